#include "noise_word.h"
#include "unity.h"

static exk_profile profile;

void setUp(void)
{
    profile = (exk_profile){.timing.from = EXK_FROM_TWIN};
}

void tearDown(void)
{
}

static void add(exk_wave wave, bool frozen)
{
    profile.twin.disturbance[profile.twin.n_disturbances++] = (exk_disturbance_config){
        .wave = wave, .channel = {true, false}, .amplitude = 1e-4, .frozen = frozen};
}

static void a_quiet_machine_has_none(void)
{
    TEST_ASSERT_EQUAL_STRING("none", exk_noise_word(&profile));
    add(EXK_WAVE_NONE, false);
    add(EXK_WAVE_GAUSSIAN, false);
    profile.twin.disturbance[1].amplitude = 0.0;
    add(EXK_WAVE_GAUSSIAN, false);
    profile.twin.disturbance[2].channel[EXK_ALPHA] = false;
    TEST_ASSERT_EQUAL_STRING("none", exk_noise_word(&profile));
}

static void frozen_and_fresh_and_both(void)
{
    add(EXK_WAVE_GAUSSIAN, true);
    TEST_ASSERT_EQUAL_STRING("frozen", exk_noise_word(&profile));
    add(EXK_WAVE_GAUSSIAN, false);
    TEST_ASSERT_EQUAL_STRING("mixed", exk_noise_word(&profile));
    profile.twin.n_disturbances = 0;
    add(EXK_WAVE_GAUSSIAN, false);
    TEST_ASSERT_EQUAL_STRING("fresh", exk_noise_word(&profile));
}

static void what_is_not_random_repeats_whatever_its_key_says(void)
{
    add(EXK_WAVE_SINE, false);
    add(EXK_WAVE_CONSTANT, false);
    TEST_ASSERT_EQUAL_STRING("frozen", exk_noise_word(&profile));
}

static void the_sensor_counts_too(void)
{
    profile.twin.sensor_sigma_rad = 1e-6;
    TEST_ASSERT_EQUAL_STRING("fresh", exk_noise_word(&profile));
    profile.twin.sensor_frozen = true;
    TEST_ASSERT_EQUAL_STRING("frozen", exk_noise_word(&profile));
    add(EXK_WAVE_GAUSSIAN, false);
    TEST_ASSERT_EQUAL_STRING("mixed", exk_noise_word(&profile));
}

static void a_replayed_log_is_neither(void)
{
    add(EXK_WAVE_GAUSSIAN, false);
    profile.timing.from = EXK_FROM_REPLAY;
    TEST_ASSERT_EQUAL_STRING("replay", exk_noise_word(&profile));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(a_quiet_machine_has_none);
    RUN_TEST(frozen_and_fresh_and_both);
    RUN_TEST(what_is_not_random_repeats_whatever_its_key_says);
    RUN_TEST(the_sensor_counts_too);
    RUN_TEST(a_replayed_log_is_neither);
    return UNITY_END();
}
