/* SPDX-License-Identifier: MIT
 *
 * The program scarp-bench: selects workloads, measures them and prints the results. Whatever can be
 * wrong with the command line is found before anything is measured or written.
 */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench.h"
#include "measure.h"
#include "options.h"
#include "peer.h"
#include "recipes.h"
#include "report.h"
#include "scarp.h"
#include "subject.h"
#include "work.h"

/* The selected subjects, and what their measurement needs. */
struct selection {
    struct bench_subject *subjects;
    size_t count;
    struct bench_arrays arrays;
    double *samples;
};

static int no_memory(void)
{
    bench_error("out of memory");
    return BENCH_FAILURE;
}

static int is_wanted(const struct bench_options *options, const char *name)
{
    const char *list = options->work;
    char pattern[128];
    while (bench_next_part(&list, pattern, sizeof pattern)) {
        if (bench_work_matches(pattern, name)) {
            return 1;
        }
    }
    return options->work == NULL;
}

/* Workloads on request are listed like all others, but measured only if --work asks for them. */
static int is_selected(const struct bench_options *options, const struct bench_work *work)
{
    if (options->list || work->request != BENCH_BY_NAME) {
        return is_wanted(options, work->name) &&
               (options->list || options->work != NULL || work->request == BENCH_ALWAYS);
    }
    const char *list = options->work;
    char name[128];
    while (bench_next_part(&list, name, sizeof name)) {
        if (strcmp(name, work->name) == 0) {
            return 1;
        }
    }
    return 0;
}

/* Adds the workload by scarp (peer NULL) or a peer, with every wanted instruction set that can. */
static int add_subjects(struct selection *selection, const struct bench_options *options,
                        const struct bench_work *work, const struct bench_peer *peer,
                        size_t scratch)
{
    for (enum scarp_isa isa = SCARP_ISA_NONE + 1; scarp_isa_name(isa) != NULL; isa++) {
        struct bench_subject subject;
        if (!(options->isas >> isa & 1) ||
            !bench_subject_make(&subject, work, peer, isa, scratch)) {
            continue;
        }
        const size_t size = (selection->count + 1) * sizeof *selection->subjects;
        struct bench_subject *const subjects = realloc(selection->subjects, size);
        if (subjects == NULL) {
            bench_subject_free(&subject);
            return no_memory();
        }
        subjects[selection->count++] = subject;
        selection->subjects = subjects;
    }
    return BENCH_SUCCESS;
}

/* Adds the workload by scarp, recipes with all sizes of scratch memory, and by all peers. */
static int add_work(struct selection *selection, const struct bench_options *options,
                    const struct bench_work *work)
{
    const int is_recipe = work->layout == BENCH_RECIPE || work->layout == BENCH_RECIPE_GRID;
    int status = add_subjects(selection, options, work, NULL, BENCH_BEST_SCRATCH);
    for (int i = 0; status == BENCH_SUCCESS && is_recipe && i < options->scratch_count; i++) {
        status = add_subjects(selection, options, work, NULL, options->scratch[i]);
    }
    for (size_t p = 0; status == BENCH_SUCCESS && options->peers && bench_peer_get(p) != NULL;
         p++) {
        status = add_subjects(selection, options, work, bench_peer_get(p), BENCH_BEST_SCRATCH);
    }
    return status;
}

/* Checks that every part of --work names something that can be measured. */
static int check_patterns(const struct selection *selection, const struct bench_options *options)
{
    const char *list = options->work;
    char pattern[128];
    while (bench_next_part(&list, pattern, sizeof pattern)) {
        size_t i = 0;
        while (i < selection->count &&
               !bench_work_matches(pattern, selection->subjects[i].work.name)) {
            i++;
        }
        if (i == selection->count) {
            bench_error("--work: '%.60s' matches nothing that can be measured here; see: "
                        "scarp-bench --list",
                        pattern);
            return BENCH_USAGE;
        }
    }
    return BENCH_SUCCESS;
}

static int select_subjects(struct selection *selection, const struct bench_options *options)
{
    struct bench_work work;
    if (options->peers && bench_peer_get(0) == NULL) {
        bench_error("--peers: no other library was found when this program was built");
        return BENCH_USAGE;
    }
    for (size_t i = 0; bench_work_get(i, &work); i++) {
        if (!is_selected(options, &work)) {
            continue;
        }
        const int status = add_work(selection, options, &work);
        if (status != BENCH_SUCCESS) {
            return status;
        }
    }
    return check_patterns(selection, options);
}

static void free_selection(struct selection *selection)
{
    for (size_t i = 0; i < selection->count; i++) {
        bench_subject_free(&selection->subjects[i]);
    }
    free(selection->subjects);
    free(selection->samples);
    bench_arrays_free(&selection->arrays);
}

static void print_list(const struct selection *selection)
{
    for (size_t i = 0; i < selection->count; i++) {
        const char *const name = selection->subjects[i].work.name;
        if (i == 0 || strcmp(name, selection->subjects[i - 1].work.name) != 0) {
            puts(name);
        }
    }
}

static void describe(struct bench_report *report, const struct bench_options *options)
{
    snprintf(report->version, sizeof report->version, "%s", scarp_version());
    bench_cpu_name(report->cpu, sizeof report->cpu);
    bench_utc_date(report->date, sizeof report->date);
#if defined(__clang__)
    snprintf(report->compiler, sizeof report->compiler, "%s", __VERSION__);
#elif defined(__GNUC__)
    snprintf(report->compiler, sizeof report->compiler, "gcc %s", __VERSION__);
#else
    snprintf(report->compiler, sizeof report->compiler, "unknown");
#endif
    snprintf(report->flags, sizeof report->flags, "%s", SCARP_BENCH_FLAGS);
    for (enum scarp_isa isa = SCARP_ISA_NONE + 1; scarp_isa_name(isa) != NULL; isa++) {
        if (scarp_isa_supported(isa)) {
            const size_t length = strlen(report->isas);
            snprintf(report->isas + length, sizeof report->isas - length, "%s%s",
                     length > 0 ? " " : "", scarp_isa_name(isa));
        }
    }
    report->min_time = options->min_time;
    report->repeat = options->repeat;
}

static void write_row_name(struct bench_row *row, const struct bench_subject *subject)
{
    snprintf(row->work, sizeof row->work, "%s", subject->work.name);
    if (subject->scratch != BENCH_BEST_SCRATCH) {
        const size_t length = strlen(row->work);
        snprintf(row->work + length, sizeof row->work - length, "/scratch=%zu", subject->scratch);
    }
}

static int prepare(struct selection *selection, struct bench_report *report)
{
    struct bench_sizes sizes = {.points = 0};
    for (size_t i = 0; i < selection->count; i++) {
        bench_sizes_raise(&sizes, &selection->subjects[i].work);
    }
    const size_t repeat = (size_t)report->repeat;
    report->rows = calloc(selection->count, sizeof *report->rows);
    selection->samples = calloc(selection->count * repeat, sizeof *selection->samples);
    if (!bench_arrays_make(&selection->arrays, &sizes) || report->rows == NULL ||
        selection->samples == NULL) {
        return no_memory();
    }
    report->count = selection->count;
    for (size_t i = 0; i < selection->count; i++) {
        struct bench_subject *const subject = &selection->subjects[i];
        struct bench_row *const row = &report->rows[i];
        subject->arrays = &selection->arrays;
        if (subject->work.as_points) {
            subject->samples_at = bench_arrays_samples(&selection->arrays, &subject->work);
            if (subject->samples_at == NULL) {
                return no_memory();
            }
        }
        subject->samples = selection->samples + i * repeat;
        subject->row = row;
        write_row_name(row, subject);
        snprintf(row->library, sizeof row->library, "%s",
                 subject->peer != NULL ? subject->peer->library : "scarp");
        snprintf(row->isa, sizeof row->isa, "%s", scarp_isa_name(subject->isa));
        snprintf(row->note, sizeof row->note, "%s", bench_subject_note(subject));
        row->points = subject->work.points;
        const enum scarp_status status = bench_subject_try(subject);
        if (status != SCARP_OK) {
            bench_error("%s: %s", row->work, scarp_status_text(status));
            return BENCH_FAILURE;
        }
    }
    return BENCH_SUCCESS;
}

static int isa_is_wanted(const struct bench_options *options, const char *name)
{
    for (enum scarp_isa isa = SCARP_ISA_NONE + 1; scarp_isa_name(isa) != NULL; isa++) {
        if (strcmp(name, scarp_isa_name(isa)) == 0) {
            return (int)(options->isas >> isa & 1);
        }
    }
    return 1;
}

/* Drops the rows that --work and --isa leave out. */
static int filter_rows(const struct bench_options *options, struct bench_report *report)
{
    size_t kept = 0;
    for (size_t i = 0; i < report->count; i++) {
        const struct bench_row row = report->rows[i];
        if (is_wanted(options, row.work) && isa_is_wanted(options, row.isa)) {
            report->rows[kept++] = row;
        }
    }
    report->count = kept;
    const char *list = options->work;
    char pattern[128];
    while (bench_next_part(&list, pattern, sizeof pattern)) {
        size_t i = 0;
        while (i < kept && !bench_work_matches(pattern, report->rows[i].work)) {
            i++;
        }
        if (i == kept) {
            bench_error("--work: '%.60s' matches nothing in %.200s", pattern, options->from);
            return BENCH_USAGE;
        }
    }
    if (kept == 0) {
        bench_error("--isa: %.200s has no such rows", options->from);
        return BENCH_USAGE;
    }
    return BENCH_SUCCESS;
}

static int read_reports(const struct bench_options *options, struct bench_report *report)
{
    const char *list = options->from;
    char name[512];
    while (bench_next_part(&list, name, sizeof name)) {
        FILE *const file = fopen(name, "r");
        if (file == NULL) {
            bench_error("--from: %.200s: %s", name, strerror(errno));
            return BENCH_USAGE;
        }
        const char *const problem = bench_read_json(file, report);
        fclose(file);
        if (problem != NULL) {
            bench_error("--from: %.200s %s", name, problem);
            return BENCH_USAGE;
        }
    }
    return filter_rows(options, report);
}

/* Checks that the file can be written, and leaves it as it was. */
static int check_writable(const char *option, const char *name)
{
    if (name == NULL || (strcmp(option, "--json") == 0 && strcmp(name, "-") == 0)) {
        return BENCH_SUCCESS;
    }
    FILE *file = fopen(name, "r+");
    const int existed = file != NULL;
    if (!existed) {
        file = fopen(name, "wx");
    }
    if (file == NULL) {
        bench_error("%s: %.200s: %s", option, name, strerror(errno));
        return BENCH_USAGE;
    }
    fclose(file);
    if (!existed) {
        remove(name);
    }
    return BENCH_SUCCESS;
}

static int write_json(FILE *file, const struct bench_report *report)
{
    bench_write_json(file, report);
    return 1;
}

static int write_file(const char *option, const char *name, const struct bench_report *report,
                      int (*write)(FILE *file, const struct bench_report *report))
{
    errno = 0;
    FILE *const file = fopen(name, "w");
    int written = file != NULL && write(file, report) && !ferror(file);
    if (file != NULL && fclose(file) != 0) {
        written = 0;
    }
    if (!written) {
        bench_error("%s: %.200s: %s", option, name, errno != 0 ? strerror(errno) : "not written");
        return BENCH_FAILURE;
    }
    return BENCH_SUCCESS;
}

static int tell(const struct bench_options *options, const struct bench_report *report)
{
    const int json_on_stdout = options->json != NULL && strcmp(options->json, "-") == 0;
    int status = BENCH_SUCCESS;
    if (options->markdown) {
        bench_write_markdown(stdout, report);
    } else if (json_on_stdout) {
        bench_write_json(stdout, report);
    } else {
        bench_write_text(stdout, report);
    }
    if (options->json != NULL && !json_on_stdout) {
        status = write_file("--json", options->json, report, write_json);
    }
    if (options->svg != NULL && status == BENCH_SUCCESS) {
        status = write_file("--svg", options->svg, report, bench_write_chart);
    }
    return status;
}

static int measure(const struct bench_options *options, struct selection *selection,
                   struct bench_report *report)
{
    const enum bench_progress progress = options->quiet               ? BENCH_PROGRESS_NONE
                                         : bench_is_terminal_stderr() ? BENCH_PROGRESS_TERMINAL
                                                                      : BENCH_PROGRESS_LINES;
    const struct bench_method method = {options->min_time, options->repeat, progress};
    describe(report, options);
    const int status = prepare(selection, report);
    if (status == BENCH_SUCCESS) {
        bench_measure(&method, selection->subjects, selection->count);
    }
    return status;
}

static int run(const struct bench_options *options, struct selection *selection,
               struct bench_report *report)
{
    int status =
        options->from != NULL ? read_reports(options, report) : select_subjects(selection, options);
    if (status == BENCH_SUCCESS && options->list) {
        print_list(selection);
        return status;
    }
    if (status == BENCH_SUCCESS) {
        status = check_writable("--json", options->json);
    }
    if (status == BENCH_SUCCESS) {
        status = check_writable("--svg", options->svg);
    }
    if (status == BENCH_SUCCESS && options->from == NULL) {
        status = measure(options, selection, report);
    }
    return status == BENCH_SUCCESS ? tell(options, report) : status;
}

int main(int argc, char **argv)
{
    struct bench_options options;
    struct selection selection = {.count = 0};
    struct bench_report report = {.count = 0};
    const enum bench_outcome outcome = bench_options_parse(&options, argc, argv);
    if (outcome == BENCH_BAD) {
        return BENCH_USAGE;
    }
    const int status = outcome == BENCH_RUN ? run(&options, &selection, &report) : BENCH_SUCCESS;
    free_selection(&selection);
    free(report.rows);
    if (fflush(stdout) != 0 || ferror(stdout)) {
        bench_error("standard output: %s", strerror(errno));
        return status == BENCH_SUCCESS ? BENCH_FAILURE : status;
    }
    return status;
}
