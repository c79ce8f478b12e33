/* SPDX-License-Identifier: MIT
 *
 * What progress.c says of the time that is left, with a clock of the test's own: it includes the
 * file, and reads what that prints on stderr.
 */
#include "../src/cli/shared/progress.c"

#include <string.h>

static double now; /* seconds */

double running_seconds(void)
{
    return now;
}

static int failures;

/* Compares what was printed since the last call with `expected`. */
static void check(FILE *file, const char *expected)
{
    static long at;
    char text[256];
    fflush(stderr);
    fseek(file, at, SEEK_SET);
    const size_t length = fread(text, 1, sizeof text - 1, file);
    text[length] = '\0';
    at += (long)length;
    if (strcmp(text, expected) != 0) {
        printf("'%s' and not '%s'\n", text, expected);
        failures++;
    }
}

static void start(struct progress *progress, uint64_t total)
{
    now = 100.0;
    progress_start(progress, total, false);
    progress->shown = true; /* though stderr is a file */
    print(progress);
}

int main(int argc, char **argv)
{
    struct progress progress;
    FILE *const file =
        argc == 2 && freopen(argv[1], "wb", stderr) != NULL ? fopen(argv[1], "rb") : NULL;
    if (file == NULL) {
        printf("usage: test_progress FILE\n");
        return 2;
    }
    start(&progress, 40); /* a short run says nothing */
    check(file, "0");
    progress_add(&progress, 39);
    now += 9.9;
    progress_add(&progress, 1);
    check(file, "...10...20...30...40...50...60...70...80...90...100");
    progress_end(&progress, true);
    check(file, " - done.\n");

    start(&progress, 400);
    progress_add(&progress, 5);
    check(file, "0");
    now += 11.0;
    progress_add(&progress, 5); /* the first tick after ten seconds: 390 of 400 are left */
    check(file, ". (7 min left)");
    now += 9.0;
    progress_add(&progress, 30);
    check(file, "..10 (3 min left)");
    progress_add(&progress, 11);
    check(file, ".");
    now += 20.0;
    progress_add(&progress, 309);
    check(file, "..20...30...40...50...60...70...80...90 (4 s left)");
    progress_add(&progress, 40);
    check(file, "...100");

    start(&progress, 1000); /* what was there took no time */
    progress_skip(&progress, 500);
    check(file, "0...10...20...30...40...50");
    now += 3600.0;
    progress_add(&progress, 100);
    check(file, "...60 (4.0 h left)");
    progress_end(&progress, false);
    check(file, "\n");
    fclose(file);
    return failures != 0;
}
