/* Cut the power after every call of a save, lose any subset of what was not synced: the store that is loaded
 * afterwards is the old generation or the new one, whole. */
#define _POSIX_C_SOURCE 200809L
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../src/store/store_on.h"
#include "power_fs.h"
#include "unity.h"

enum { N = 6, WRITES = 3, MANY_CALLS = 64 };
static power_fs fs;
static power_fs after;
static power_fs again;
static char why[512];

void setUp(void)
{
    power_fs_init(&fs);
}

void tearDown(void)
{
}

static void fill(exk_store *store, uint32_t generation)
{
    TEST_ASSERT_EQUAL(EXK_STORE_OK, exk_store_alloc(store, N));
    store->iteration = generation;
    store->dt_s = 0.001;
    for (int i = 0; i < EXK_N_AXES; i++) {
        for (int k = 0; k < N; k++) {
            store->u_rad[i][k] = generation + 0.1 * k - i;
        }
    }
}

static exk_store_err save(power_fs *to, uint32_t generation)
{
    exk_store store;
    const store_os os = power_fs_calls(to);
    fill(&store, generation);
    const exk_store_err err = store_save_on(&os, "a.ilc", &store, why, sizeof why);
    exk_store_free(&store);
    return err;
}

/* The generation that is there, to the bit; 0: none is good; -1: a mix. */
static int generation(power_fs *from)
{
    exk_store got;
    exk_store want;
    const store_os os = power_fs_calls(from);
    if (store_load_on(&os, "a.ilc", &got, why, sizeof why) != EXK_STORE_OK) {
        return 0;
    }
    fill(&want, got.iteration);
    bool same = got.n_samples == N;
    for (int i = 0; i < EXK_N_AXES && same; i++) {
        same = memcmp(got.u_rad[i], want.u_rad[i], N * sizeof(double)) == 0;
    }
    const int found = same ? (int)got.iteration : -1;
    exk_store_free(&got);
    exk_store_free(&want);
    return found;
}

static size_t file_of(uint32_t number, unsigned char *bytes)
{
    power_fs one;
    power_fs_init(&one);
    TEST_ASSERT_EQUAL(EXK_STORE_OK, save(&one, number));
    const fs_data *data = &one.now[power_fs_find(&one, "a.ilc")];
    memcpy(bytes, data->bytes, data->n);
    return data->n;
}

static void put(const char *name, uint32_t number, bool damaged)
{
    unsigned char bytes[FS_BYTES];
    const size_t n = file_of(number, bytes);
    bytes[n / 2] ^= damaged ? 4U : 0U;
    power_fs_put(&fs, name, bytes, n);
    fs.write_max = n / WRITES + 1;
}

typedef struct {
    const char *name;
    int at_name;     /* generation under a.ilc, 0 none, negative: damaged */
    int at_previous; /* the same under a.ilc.prev */
    bool leftover;   /* a.ilc.new is there, and the same file as a.ilc */
    int old;         /* what is loaded before the save */
    int worst;       /* and the worst that may be loaded after a cut */
} start_state;

/* Nothing stored yet: the new one, or still nothing. */
static const start_state starts[] = {
    {"nothing there", 0, 0, false, 0, 0},
    {"one generation", 1, 0, false, 1, 1},
    {"two generations", 2, 1, false, 2, 2},
    {"only a previous one", 0, 1, false, 1, 1},
    {"damaged, with a previous one", -2, 1, false, 1, 1},
    {"both damaged", -2, -1, false, 0, 0},
    {"a leftover of a crash that is the good file itself", 2, 1, true, 2, 2},
};

static void set_up(const start_state *start, bool no_links)
{
    power_fs_init(&fs);
    fs.no_links = no_links;
    fs.write_max = 70;
    if (start->at_name != 0) {
        put("a.ilc", (uint32_t)abs(start->at_name), start->at_name < 0);
    }
    if (start->at_previous != 0) {
        put("a.ilc.prev", (uint32_t)abs(start->at_previous), start->at_previous < 0);
    }
    if (start->leftover) {
        const store_os os = power_fs_calls(&fs);
        fs.no_links = false;
        os.link(os.ctx, "a.ilc", "a.ilc.new");
        fs.no_links = no_links;
        memcpy(fs.kept_names, fs.now_names, sizeof fs.kept_names);
        fs.n_ops = 0;
    }
    fs.n_calls = 0;
    TEST_ASSERT_EQUAL_MESSAGE(start->old, generation(&fs), start->name);
}

/* Every outcome of a loss of power now; returns how many were looked at. */
static long check_outcomes(const start_state *start, int fresh)
{
    const long n = power_fs_outcomes(&fs);
    for (long choice = 0; choice < n; choice++) {
        power_fs_after(&fs, choice, &after);
        const int found = generation(&after);
        TEST_ASSERT_TRUE_MESSAGE(found == start->old || found == fresh, start->name);
        TEST_ASSERT_TRUE_MESSAGE(found >= start->worst, start->name);
        again = after;
        TEST_ASSERT_EQUAL_MESSAGE(EXK_STORE_OK, save(&again, 9), why);
        TEST_ASSERT_EQUAL_MESSAGE(9, generation(&again), start->name);
    }
    return n;
}

static void every_cut_leaves_the_old_or_the_new_generation(void)
{
    long n_outcomes = 0;
    int n_cuts = 0;
    for (size_t i = 0; i < 2 * sizeof starts / sizeof starts[0]; i++) {
        const start_state *start = &starts[i / 2];
        exk_store_err err = EXK_STORE_IO;
        for (int cut = 0; cut < MANY_CALLS && err != EXK_STORE_OK; cut++) {
            set_up(start, i % 2 == 1);
            fs.cut = cut;
            err = save(&fs, 3);
            n_outcomes += check_outcomes(start, 3);
            n_cuts++;
        }
        TEST_ASSERT_EQUAL_MESSAGE(EXK_STORE_OK, err, start->name);
        power_fs_after(&fs, 0, &after); /* a save that said yes is there for good */
        TEST_ASSERT_EQUAL_MESSAGE(3, generation(&after), start->name);
    }
    printf("%d cut points, %ld outcomes\n", n_cuts, n_outcomes);
    TEST_ASSERT_GREATER_THAN(100, n_cuts);
}

/* One call fails, the process lives: the old one stays, or the new one is there; saving again works. */
static void every_failing_call_leaves_the_old_or_the_new_generation(void)
{
    for (size_t i = 0; i < 2 * sizeof starts / sizeof starts[0]; i++) {
        const start_state *start = &starts[i / 2];
        bool reached = true;
        for (int call = 0; reached; call++) {
            set_up(start, i % 2 == 1);
            fs.fail = call;
            const exk_store_err err = save(&fs, 3);
            reached = fs.n_calls > call;
            const int found = generation(&fs);
            TEST_ASSERT_TRUE_MESSAGE(found == start->old || found == 3, start->name);
            TEST_ASSERT_TRUE_MESSAGE(err != EXK_STORE_OK || found == 3, start->name);
            check_outcomes(start, 3);
        }
    }
}

/* The shim finds what it is for: with an fsync that does nothing, generations are lost or mixed. */
static void a_save_without_fsync_is_found_out(void)
{
    long n_lost = 0;
    set_up(&starts[1], false);
    fs.no_fsync = true;
    TEST_ASSERT_EQUAL(EXK_STORE_OK, save(&fs, 3));
    for (long choice = 0; choice < power_fs_outcomes(&fs); choice++) {
        power_fs_after(&fs, choice, &after);
        const int found = generation(&after);
        n_lost += found != 1 && found != 3 ? 1 : 0;
    }
    TEST_ASSERT_GREATER_THAN(0, n_lost);
}

static void the_generation_before_is_kept_whole(void)
{
    set_up(&starts[1], false);
    TEST_ASSERT_EQUAL(EXK_STORE_OK, save(&fs, 2));
    TEST_ASSERT_EQUAL(EXK_STORE_OK, save(&fs, 3));
    const int file = power_fs_find(&fs, "a.ilc");
    fs.now[file].bytes[60] ^= 1U;
    TEST_ASSERT_EQUAL(2, generation(&fs));
    TEST_ASSERT_EQUAL(-1, power_fs_find(&fs, "a.ilc.new"));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(every_cut_leaves_the_old_or_the_new_generation);
    RUN_TEST(every_failing_call_leaves_the_old_or_the_new_generation);
    RUN_TEST(a_save_without_fsync_is_found_out);
    RUN_TEST(the_generation_before_is_kept_whole);
    return UNITY_END();
}
