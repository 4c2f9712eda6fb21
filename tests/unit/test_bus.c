#include <string.h>

#include "exk/bus.h"
#include "unity.h"

/* A port of this test alone. */
static const char url[] = "udpm://239.255.76.67:20061?ttl=0";
static char why[512];
static int n_received;
static char last[64];

void setUp(void)
{
    n_received = 0;
    why[0] = '\0';
}

void tearDown(void)
{
}

static void take(void *ctx, const char *channel, const void *data, size_t bytes,
                 int64_t received_us)
{
    TEST_ASSERT_EQUAL_PTR(last, ctx);
    TEST_ASSERT_EQUAL_STRING("EXK_POSE", channel);
    TEST_ASSERT_LESS_THAN(sizeof last, bytes);
    TEST_ASSERT_GREATER_THAN_INT64(1500000000000000, received_us);
    memcpy(last, data, bytes);
    n_received++;
}

static void urls_that_cannot_work_are_refused_with_the_reason(void)
{
    static const char *const rows[][2] = {
        {"", "LCM URL \"\": it is empty"},
        {"239.255.76.67:7667", "no :// is in it"},
        {"udpm:/239.255.76.67:7667", "no :// is in it"},
        {"carrier-pigeon://", "unknown kind: udpm, tcpq, memq, file or mpudpm is allowed"},
        {"UDPM://239.255.76.67:7667", "unknown kind"},
        {"udp://239.255.76.67:7667", "unknown kind"},
        {"udpm://10.0.0.1:7667",
         "its group is not a multicast address (224.0.0.0 to 239.255.255.255)"},
        {"udpm://nonsense", "its group is not"},
        {"udpm://", "its group is not"},
        {"udpm://240.0.0.1:1", "its group is not"},
        {"udpm://239.255.76.67", "a port, 1 to 65535, has to stand behind the group"},
        {"udpm://239.255.76.67?ttl=0", "a port, 1 to 65535"},
        {"udpm://239.255.76.67:", "a port, 1 to 65535"},
        {"udpm://239.255.76.67:0", "a port, 1 to 65535"},
        {"udpm://239.255.76.67:65536", "a port, 1 to 65535"},
        {"udpm://239.255.76.67:-5", "a port, 1 to 65535"},
        {"udpm://239.255.76.67:7667x", "a port, 1 to 65535"},
        {"udpm://239.255.76.67:7667?ttl=x", "ttl is a whole number"},
        {"udpm://239.255.76.67:7667?ttl=256", "ttl is a whole number"},
        {"udpm://239.255.76.67:7667?ttl=1&recv_buf_size=",
         "recv_buf_size is a number of bytes"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        TEST_ASSERT_NULL_MESSAGE(exk_bus_open(rows[i][0], true, why, sizeof why), rows[i][0]);
        TEST_ASSERT_NOT_NULL_MESSAGE(strstr(why, rows[i][1]), why);
        TEST_ASSERT_FALSE(exk_bus_url_good(rows[i][0], why, sizeof why));
    }
}

/* Well written, but not to be had here: not the same as wrong use. */
static void a_good_url_that_cannot_be_opened_is_another_thing(void)
{
    static const char *const rows[] = {"tcpq://127.0.0.1:1",
                                       "file:///no/such/folder/x.lcm?mode=w"};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        TEST_ASSERT_TRUE_MESSAGE(exk_bus_url_good(rows[i], why, sizeof why), why);
        TEST_ASSERT_NULL_MESSAGE(exk_bus_open(rows[i], true, why, sizeof why), rows[i]);
        TEST_ASSERT_NOT_NULL_MESSAGE(strstr(why, "LCM cannot open this URL"), why);
    }
    TEST_ASSERT_TRUE(exk_bus_url_good(url, why, sizeof why));
    TEST_ASSERT_TRUE(
        exk_bus_url_good("udpm://239.1.2.3:1?recv_buf_size=1000&ttl=255", why, sizeof why));
}

static void other_kinds_of_url_need_no_route(void)
{
    TEST_ASSERT_TRUE(exk_bus_route("memq://", why, sizeof why));
    TEST_ASSERT_TRUE(exk_bus_route("file:///tmp/x.lcm?mode=w", why, sizeof why));
}

static void the_time_to_live_is_read_from_the_url(void)
{
    TEST_ASSERT_EQUAL(0, exk_bus_ttl("udpm://239.255.76.67:7667"));
    TEST_ASSERT_EQUAL(0, exk_bus_ttl(url));
    TEST_ASSERT_EQUAL(3, exk_bus_ttl("udpm://239.255.76.67:7667?recv_buf_size=1&ttl=3"));
}

static void the_system_grants_some_buffer(void)
{
    TEST_ASSERT_GREATER_THAN_INT64(2048, exk_bus_granted_bytes());
    TEST_ASSERT_LESS_OR_EQUAL_INT64(EXK_BUS_BUFFER_BYTES, exk_bus_granted_bytes());
}

/* More messages than LCM's own queue of 30 would keep, sent before the first one is fetched. */
static void nothing_is_dropped_behind_the_socket(void)
{
    enum { N = 1000 };
    if (!exk_bus_route(url, why, sizeof why)) {
        TEST_IGNORE_MESSAGE(why);
    }
    exk_bus *in = exk_bus_open(url, true, why, sizeof why);
    exk_bus *out = exk_bus_open(url, false, why, sizeof why);
    TEST_ASSERT_NOT_NULL_MESSAGE(in, why);
    TEST_ASSERT_NOT_NULL_MESSAGE(out, why);
    TEST_ASSERT_TRUE_MESSAGE(exk_bus_listen(in, "EXK_.*", take, last, why, sizeof why), why);
    for (int i = 0; i < N; i++) {
        TEST_ASSERT_TRUE(exk_bus_send(out, i % 2 == 0 ? "EXK_POSE" : "ELSEWHERE", "hello", 6));
    }
    while (n_received < N / 2 && exk_bus_wait(in, 1000) > 0) {
    }
    TEST_ASSERT_EQUAL(N / 2, n_received);
    TEST_ASSERT_EQUAL_STRING("hello", last);
    TEST_ASSERT_EQUAL(0, exk_bus_wait(in, 0));
    exk_bus_close(in);
    exk_bus_close(out);
    exk_bus_close(NULL);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(urls_that_cannot_work_are_refused_with_the_reason);
    RUN_TEST(a_good_url_that_cannot_be_opened_is_another_thing);
    RUN_TEST(other_kinds_of_url_need_no_route);
    RUN_TEST(the_time_to_live_is_read_from_the_url);
    RUN_TEST(the_system_grants_some_buffer);
    RUN_TEST(nothing_is_dropped_behind_the_socket);
    return UNITY_END();
}
