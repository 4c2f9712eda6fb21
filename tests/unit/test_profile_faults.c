/* One row a kind of fault: the text, and every message that must come of it, word for word. */
#include <stdio.h>
#include <string.h>

#include "exk/profile.h"
#include "unity.h"

enum { MAX_FAULTS = 16, MAX_WANTED = 6 };

#define START "[kinematics]\nmodel = pendulum\n[job]\nkind = rectangle\n" /* lines 1 to 4 */

typedef struct {
    const char *name;
    const char *text;
    exk_fault want[MAX_WANTED];
} row;

static const row rows[] = {
    {"commands without a key",
     START "[command]\nallow = yes\n",
     {{6,
       "[command]: missing key key_file; allow = yes needs the key that commands are checked "
       "with (exk-command keygen FILE makes one)"}}},
    {"waiting for what is not allowed",
     START "[command]\nwait = yes\n",
     {{6, "[command] wait: yes would wait for ever: no command is allowed; add allow = yes"}}},
    {"a text of no letters",
     START "file =\n",
     {{5, "[job] file: no value: found \"\", allowed: text"}}},
    {"a text that is a comment to its reader",
     START "file =; note\n",
     {{5, "[job] file: no value: found \"; note\", allowed: text"}}},
    {"a ratio of a length that is refused already, upper",
     START "[machine]\nd1_mm = x\nd5_mm = 1500\n",
     {{6, "[machine] d1_mm: not a number: found \"x\", allowed: 1 to 100000 mm"}}},
    {"a ratio of a length that is refused already, lower",
     START "[machine]\nd3_mm = x\nd4_mm = 500\n",
     {{6, "[machine] d3_mm: not a number: found \"x\", allowed: 1 to 100000 mm"}}},
    {"a key longer than any, with no guess",
     START "bbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbb = 3\n",
     {{5,
       "[job] bbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbb: unknown key; allowed: kind, width_mm, "
       "height_mm, rows, columns, center_x_mm, center_y_mm, plane_z_mm, file, order, "
       "row_gap_mm, tolerance_mm, closed, feed_mmps, approach_mmps, drill_mmps, retract_mmps, "
       "acc..."}}},
    {"unknown key",
     START "zebra = 1\n[sensor]\nzebra = 1\n",
     {{5,
       "[job] zebra: unknown key; allowed: kind, width_mm, height_mm, rows, columns, "
       "center_x_mm, center_y_mm, plane_z_mm, file, order, row_gap_mm, tolerance_mm, closed, "
       "feed_mmps, approach_mmps, drill_mmps, retract_mmps, accel_mmps2, clearance_mm, "
       "stroke_mm, ..."},
      {7, "[sensor] zebra: unknown key; allowed: sigma_rad, quantum_rad, repeat"}}},
    {"unknown key, a slip of the pen",
     START "tolerence_mm = 0.03\nClosed = yes\n",
     {{5, "[job] tolerence_mm: unknown key; did you mean tolerance_mm?"},
      {6, "[job] Closed: unknown key; did you mean closed?"}}},
    {"unknown key, of another section",
     START "rate_Hz = 1000\n",
     {{5, "[job] rate_Hz: unknown key here; it belongs to [loop]"}}},
    {"wrong unit",
     START "tolerance_m = 3e-5\n[loop]\nrate_kHz = 1\nrate_hz = 1000\n",
     {{5, "[job] tolerance_m: wrong unit; write tolerance_mm"},
      {7, "[loop] rate_kHz: wrong unit; write rate_Hz"},
      {8, "[loop] rate_hz: wrong unit; write rate_Hz"}}},
    {"no unit", START "feed = 100\n", {{5, "[job] feed: wrong unit; write feed_mmps"}}},
    {"wrong unit, several would do",
     START "[disturbance.1]\nwave = sine\nfreq_Hz = 1\namplitude_mrad = 1\n",
     {{8,
       "[disturbance.1] amplitude_mrad: wrong unit; write amplitude_rad or amplitude_radps or "
       "amplitude_radps2"}}},
    {"missing sections",
     "",
     {{0, "missing section [kinematics]; add it with model = pendulum, universal or machine"},
      {0, "missing section [job]; add it with kind = rectangle, grid or csv"}}},
    {"missing section, with a job",
     "[job]\nkind = grid\n",
     {{0, "missing section [kinematics]; add it with model = pendulum, universal or machine"}}},
    {"missing section [job]",
     "[kinematics]\nmodel = machine\n",
     {{0, "missing section [job]; add it with kind = rectangle, grid or csv"}}},
    {"missing key",
     "[kinematics]\n[job]\nkind = grid\n",
     {{1, "[kinematics]: missing key model; allowed: pendulum, universal or machine"}}},
    {"missing file names",
     "[kinematics]\nmodel = pendulum\n[job]\nkind = csv\n[loop]\nsource = replay\n",
     {{4, "[job]: missing key file; kind = csv needs the name of a CSV of holes"},
      {6, "[loop]: missing key replay_file; source = replay needs the log to read"}}},
    {"unknown section",
     "[kinematics]\nmodel = pendulum\n[jobs]\nkind = grid\n[job]\nkind = "
     "grid\n[Loop]\n[zebra]\n",
     {{3, "[jobs]: unknown section; did you mean [job]?"},
      {7, "[Loop]: unknown section; did you mean [loop]?"},
      {8, "[zebra]: unknown section; allowed: [machine] [kinematics] [job] [disturbance.N] "
          "[sensor] [control] [loop] [guard] [limits] [fault.N] [telemetry] [command]"}}},
    {"guard, limits and injected faults",
     START "[guard]\nspike_sigmas = 0\n[limits]\nx_min_mm = 50\nx_max_mm = 40\n"
           "[fault.1]\nat_s = 1\n[fault.2]\nkind = delay\ndelay_s = 0.3\n[fault.9]\n",
     {{6, "[guard] spike_sigmas: out of range: found \"0\", allowed: above 0, or inf"},
      {8, "[limits] x_min_mm: not below its max: found 50, allowed: below 40 mm"},
      {10, "[fault.1]: missing key kind; allowed: none, nan, inf, range, spike, stuck, "
           "dropout, delay or garbage"},
      {14, "[fault.2] delay_s: out of range: found 0.3, allowed: up to 255 ticks = 0.255 s"},
      {15, "[fault.9]: unknown section; allowed: [fault.1] to [fault.8]"}}},
    {"a margin that leaves no stroke, a rest without end, a spread beyond any range",
     "[kinematics]\nmodel = machine\n[job]\nkind = grid\n[limits]\nleg_margin_mm = 350\n"
     "[guard]\nretract_after_s = 3601\nsigma_rad = 1e300\n",
     {{6, "[limits] leg_margin_mm: leaves no stroke: found 350, allowed: below half of d5_mm = "
          "350 mm"},
      {8, "[guard] retract_after_s: out of range: found \"3601\", allowed: 0 to 3600 s"},
      {9, "[guard] sigma_rad: out of range: found \"1e300\", allowed: 0 to 1 rad"}}},
    {"a disturbance of no number",
     START "[disturbance]\n[disturbance.0]\n[disturbance.9]\n[disturbance.10]\n",
     {{5, "[disturbance]: unknown section; allowed: [disturbance.1] to [disturbance.8]"},
      {6, "[disturbance.0]: unknown section; allowed: [disturbance.1] to [disturbance.8]"},
      {7, "[disturbance.9]: unknown section; allowed: [disturbance.1] to [disturbance.8]"},
      {8, "[disturbance.10]: unknown section; allowed: [disturbance.1] to [disturbance.8]"}}},
    {"not a number",
     START "feed_mmps = fast\ndwell_s =\nrows = 2.5\nwidth_mm = 3,5\nheight_mm = 0x10\n",
     {{5, "[job] feed_mmps: not a number: found \"fast\", allowed: above 0 mm/s"},
      {6, "[job] dwell_s: no value: found \"\", allowed: 0 s or more"},
      {7, "[job] rows: not a whole number: found \"2.5\", allowed: whole number, 1 to 4096"},
      {8, "[job] width_mm: not a number: found \"3,5\", allowed: above 0 mm"},
      {9, "[job] height_mm: not a number: found \"0x10\", allowed: above 0 mm"}}},
    {"NaN and infinity",
     START "feed_mmps = nan\naccel_mmps2 = NaN\ndwell_s = inf\ncenter_x_mm = -inf\nstroke_mm = "
           "1e999\n",
     {{5, "[job] feed_mmps: NaN is no value: found \"nan\", allowed: above 0 mm/s"},
      {6, "[job] accel_mmps2: NaN is no value: found \"NaN\", allowed: above 0 mm/s^2, or inf"},
      {7, "[job] dwell_s: out of range: found \"inf\", allowed: 0 s or more"},
      {8, "[job] center_x_mm: out of range: found \"-inf\", allowed: any finite number"},
      {9, "[job] stroke_mm: out of range: found \"1e999\", allowed: 0 mm or more"}}},
    {"lost in the conversion to metres",
     START "height_mm = 1e-323\n",
     {{5, "[job] height_mm: too small to tell from 0: found \"1e-323\", allowed: above 0 mm"}}},
    {"negative rate",
     START "[loop]\nrate_Hz = -1000\n",
     {{6, "[loop] rate_Hz: out of range: found \"-1000\", allowed: 1 to 40000 Hz"}}},
    {"out of range",
     START "feed_mmps = 0\n[machine]\nangle_max_deg = 61\n[loop]\npriority = 100\nseed = -1\n"
           "seed = 18446744073709551616\n[control]\nilc_gain = 2.5\n",
     {{5, "[job] feed_mmps: out of range: found \"0\", allowed: above 0 mm/s"},
      {7, "[machine] angle_max_deg: out of range: found \"61\", allowed: above 0 to 60 deg"},
      {9, "[loop] priority: out of range: found \"100\", allowed: whole number, 0 to 99"},
      {10, "[loop] seed: not a whole number: found \"-1\", allowed: whole number, 0 to "
           "18446744073709551615"},
      {11, "[loop] seed: given twice: first in line 10; keep one"},
      {13, "[control] ilc_gain: out of range: found \"2.5\", allowed: above 0 to 2"}}},
    {"seed beyond 64 bits",
     START "[loop]\nseed = 18446744073709551616\n",
     {{6, "[loop] seed: out of range: found \"18446744073709551616\", allowed: whole number, 0 "
          "to 18446744073709551615"}}},
    {"unknown word",
     START "order = snake\nclosed = true\n[disturbance.1]\nwave = Sine\nchannel =\n",
     {{5, "[job] order: unknown word: found \"snake\", allowed: listed or serpentine"},
      {6, "[job] closed: unknown word: found \"true\", allowed: no or yes"},
      {8,
       "[disturbance.1] wave: unknown word: found \"Sine\", allowed: none, constant, sine or "
       "gaussian"},
      {9, "[disturbance.1] channel: no value: found \"\", allowed: alpha, beta or both"}}},
    {"key given twice",
     START "width_mm = 100\nheight_mm = 90\nwidth_mm = 100\n[job]\nkind = grid\n",
     {{7, "[job] width_mm: given twice: first in line 5; keep one"},
      {9, "[job] kind: given twice: first in line 4; keep one"}}},
    {"before the first section",
     "seed = 1\n" START,
     {{1, "seed: stands before the first section; put it under its [section]"}}},
    {"not understood",
     START "columns 5\n= 5\n[loop\n[loop] x\n",
     {{5, "not understood: found \"columns 5\", allowed: [section], key = value, or a comment "
          "after ; or #"},
      {6,
       "not understood: found \"= 5\", allowed: [section], key = value, or a comment after ; "
       "or #"},
      {7,
       "not understood: found \"[loop\", allowed: [section], key = value, or a comment after ; "
       "or #"},
      {8, "not understood: found \"[loop] x\", allowed: [section], key = value, or a comment "
          "after ; or #"}}},
    {"control characters and long words are made safe",
     START "feed_mmps = \x1b[31m\nwidth_mm = 1234567890123456789012345678901234567890123\n"
           "height_mm = aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa\n",
     {{5, "[job] feed_mmps: not a number: found \"?[31m\", allowed: above 0 mm/s"},
      {7,
       "[job] height_mm: not a number: found \"aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa...\", "
       "allowed: above 0 mm"}}},
    {"d3 outside its ratio",
     START "[machine]\nd3_mm = 540\nd4_mm = 405\n",
     {{6, "[machine] d3_mm: ratio p3 = 2 d3/d1 out of range: found 1.2, allowed: 0.5 to 1 "
          "(d3_mm = "
          "540, d1_mm = 900); choose d3_mm 225 to 450"}}},
    {"d3 outside both its ratios",
     START "[machine]\nd3_mm = 200\n",
     {{6, "[machine] d3_mm: ratio p3 = 2 d3/d1 out of range: found 0.444, allowed: 0.5 to 1 "
          "(d3_mm "
          "= 200, d1_mm = 900); choose d3_mm 225 to 450"},
      {6, "[machine] d3_mm: ratio p4 = d4/d3 out of range: found 1.35, allowed: 0.75 (d4_mm = "
          "270, d3_mm = 200); choose d3_mm 360"}}},
    {"d5 too short, another key refused",
     START "[machine]\nd5_mm = 500\nangle_max_deg = 0\n",
     {{6, "[machine] d5_mm: ratio p1 = d1/(2 d5) out of range: found 0.9, allowed: 0.5 to 0.8 "
          "(d1_mm = 900, d5_mm = 500); choose d5_mm 562.5 to 900"},
      {7, "[machine] angle_max_deg: out of range: found \"0\", allowed: above 0 to 60 deg"}}},
    {"no ratio of a length that is none",
     START "[machine]\nd3_mm = -360\n",
     {{6, "[machine] d3_mm: out of range: found \"-360\", allowed: 1 to 100000 mm"}}},
    {"unstable PI",
     START "[control]\nkp = 0.5\nki_per_s = 1500\n",
     {{7, "[control] ki_per_s: unstable with one step of delay: found 1500 with kp = 0.5, "
          "allowed: "
          "below 2 (1 - kp) rate_Hz = 1000 1/s"}}},
    {"kp of 1",
     START "[control]\nkp = 1\n",
     {{6, "[control] kp: unstable with one step of delay: found 1, allowed: below 1"}}},
    {"unstable derivative",
     START "[control]\nkd_s = 0.01\n",
     {{6,
       "[control] kd_s: unstable with one step of delay: found 0.01 with kp = 0, ki_per_s = 2, "
       "d_filter_s = 0; lower kd_s or lengthen d_filter_s"}}},
    {"learning that would not settle",
     START "[control]\nilc_gain = 1.5\nilc_d_gain_s = 0.001\n",
     {{6, "[control] ilc_gain: learning would not settle: found ilc_gain = 1.5, ilc_d_gain_s "
          "rate_Hz = 1, allowed: ilc_gain + 2 ilc_d_gain_s rate_Hz below 2"}}},
    {"learning filter too fast",
     START "[control]\nilc_cutoff_Hz = 250\n",
     {{6,
       "[control] ilc_cutoff_Hz: out of range: found 250, allowed: below rate_Hz/4 = 250 Hz"}}},
    {"ring of no power of two",
     START "[telemetry]\nring_slots = 1000\n",
     {{6, "[telemetry] ring_slots: not a power of two: found 1000, allowed: 2, 4, 8, ... "
          "4194304"}}},
    {"more holes than allowed",
     "[kinematics]\nmodel = pendulum\n[job]\nkind = grid\nrows = 100\ncolumns = 41\n",
     {{5, "[job] rows: too many holes: found rows * columns = 4100, allowed 4096"}}},
    {"amplitude of another order",
     START "[disturbance.3]\nwave = gaussian\norder = 1\nsigma_rad = 1e-5\n",
     {{8, "[disturbance.3] sigma_rad: does not fit wave = gaussian with order = 1; write "
          "sigma_rad_per_sqrt_s"}}},
    {"amplitude of another wave",
     START
     "[disturbance.1]\nwave = constant\norder = 2\nsigma_rad = 1e-5\namplitude_radps2 = 1\n",
     {{8, "[disturbance.1] sigma_rad: does not fit wave = constant with order = 2; write "
          "amplitude_radps2"}}},
    {"amplitude of no wave",
     START "[disturbance.1]\nwave = none\namplitude_rad = 1\n",
     {{7, "[disturbance.1] amplitude_rad: wave = none takes none; remove it"}}},
    {"no amplitude, no frequency, no wave",
     START "[disturbance.1]\nwave = sine\n[disturbance.2]\norder = 1\n",
     {{5, "[disturbance.1]: missing key amplitude_rad; wave = sine with order = 0 needs it"},
      {5, "[disturbance.1]: missing key freq_Hz; wave = sine with order = 0 needs it"},
      {7, "[disturbance.2]: missing key wave; allowed: none, constant, sine or gaussian"}}},
};

static exk_fault faults[MAX_FAULTS];
static exk_profile profile;

void setUp(void)
{
    memset(faults, 0, sizeof(faults));
}

void tearDown(void)
{
}

static void check_row(const row *r)
{
    char what[64];
    size_t n = 0;
    size_t n_want = 0;
    while (n_want < MAX_WANTED && r->want[n_want].message[0] != '\0') {
        n_want++;
    }
    TEST_ASSERT_EQUAL_MESSAGE(
        EXK_ERR_ARG, exk_profile_parse(r->text, &profile, faults, MAX_FAULTS, &n), r->name);
    for (size_t i = 0; i < n && i < n_want; i++) {
        snprintf(what, sizeof(what), "%s, fault %zu", r->name, i + 1);
        TEST_ASSERT_EQUAL_STRING_MESSAGE(r->want[i].message, faults[i].message, what);
        TEST_ASSERT_EQUAL_INT_MESSAGE(r->want[i].line, faults[i].line, what);
    }
    TEST_ASSERT_EQUAL_UINT_MESSAGE(n_want, n, r->name);
}

static void every_kind_of_fault_says_what_where_and_what_is_allowed(void)
{
    for (size_t i = 0; i < sizeof(rows) / sizeof(rows[0]); i++) {
        check_row(&rows[i]);
    }
}

static void a_line_beyond_the_buffer_is_named(void)
{
    char text[1024];
    size_t n = 0;
    snprintf(text, sizeof(text), START "; %0197d\nwidth_mm = %0187d\n", 0, 5);
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_profile_parse(text, &profile, faults, MAX_FAULTS, &n));
    TEST_ASSERT_EQUAL_UINT(1, n);
    TEST_ASSERT_EQUAL_INT(5, faults[0].line);
    TEST_ASSERT_EQUAL_STRING(
        "line too long: found 199 characters, allowed 198; shorten it or move "
        "the comment to a line of its own",
        faults[0].message);
}

static void a_refused_text_leaves_the_profile_alone(void)
{
    size_t n = 0;
    exk_profile before = exk_profile_default();
    before.job.tolerance_m = 7.0;
    profile = before;
    exk_profile_parse("[job]\ntolerance_mm = 1\n", &profile, faults, MAX_FAULTS, &n);
    TEST_ASSERT_TRUE(profile.job.tolerance_m == 7.0);
}

/* Faults of one rule come after those of the lines; the list is in line order all the same, and a
 * short list keeps the first lines and counts the rest. */
static void a_short_list_keeps_the_first_lines(void)
{
    const char *text = "[telemetry]\nring_slots = 3\n[job]\nrows = x\ncolumns = y\n";
    size_t n = 0;
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_profile_parse(text, &profile, faults, 4, &n));
    TEST_ASSERT_EQUAL_UINT(5, n);
    TEST_ASSERT_EQUAL_INT(0, faults[0].line);
    TEST_ASSERT_EQUAL_INT(2, faults[1].line);
    TEST_ASSERT_EQUAL_INT(3, faults[2].line);
    TEST_ASSERT_EQUAL_INT(4, faults[3].line);
    TEST_ASSERT_EQUAL_STRING("", faults[4].message);
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_profile_parse(text, &profile, NULL, 0, &n));
    TEST_ASSERT_EQUAL_UINT(5, n);
}

/* The other side of each rule between keys. */
static void what_belongs_together_is_good(void)
{
    static const char *const good[] = {
        START "[command]\nallow = yes\nwait = yes\nkey_file = k\n",
        START "[loop]\nsource = replay\nreplay_file = run.lcm\n",
        START "[fault.1]\nkind = delay\ndelay_s = 0.01\n",
        START "feed_mmps = 1e+2\n",
    };
    for (size_t i = 0; i < sizeof good / sizeof good[0]; i++) {
        size_t n = 0;
        TEST_ASSERT_EQUAL_MESSAGE(
            EXK_OK, exk_profile_parse(good[i], &profile, faults, MAX_FAULTS, &n), good[i]);
    }
}

/* The highest number counts, in whatever order they stand. */
static void numbered_sections_may_stand_in_any_order(void)
{
    static const char text[] =
        START "[fault.2]\nkind = nan\n[fault.1]\nkind = inf\n[disturbance.2]\nwave = none\n"
              "[disturbance.1]\nwave = none\n";
    size_t n = 0;
    TEST_ASSERT_EQUAL(EXK_OK, exk_profile_parse(text, &profile, faults, MAX_FAULTS, &n));
    TEST_ASSERT_EQUAL_UINT(2, profile.inject.n_faults);
    TEST_ASSERT_EQUAL(EXK_INJECT_INF, profile.inject.fault[0].kind);
    TEST_ASSERT_EQUAL_UINT(2, profile.twin.n_disturbances);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(every_kind_of_fault_says_what_where_and_what_is_allowed);
    RUN_TEST(a_line_beyond_the_buffer_is_named);
    RUN_TEST(a_refused_text_leaves_the_profile_alone);
    RUN_TEST(a_short_list_keeps_the_first_lines);
    RUN_TEST(what_belongs_together_is_good);
    RUN_TEST(numbered_sections_may_stand_in_any_order);
    return UNITY_END();
}
