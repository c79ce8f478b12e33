/* SPDX-License-Identifier: MIT
 *
 * Writes the shader of a recipe to standard output, and its uniform buffer and its answers to
 * files.
 */
#include "recipe/shader.h"

#include <errno.h>
#include <stdlib.h>

#include "shared/error.h"
#include "shared/file.h"

const char *shader_word(int language)
{
    static const char *const words[] = {"glsl", "hlsl", "wgsl", NULL};
    return words[language];
}

static int write_file(const char *path, const void *bytes, size_t size)
{
    struct file file = {.stream = NULL};
    errno = 0;
    const bool done = file_open(&file, path) && file_write(&file, bytes, size) &&
                      file_close(&file) && file_publish(&file) && file_settle(&file);
    const int reason = errno;
    file_discard(&file);
    if (!done) {
        cli_error("%s: %s", file_name(path), file_reason(reason));
    }
    return done ? CLI_SUCCESS : CLI_FAILURE;
}

static int refuse(enum scarp_status status)
{
    cli_error("recipe: it has no shader: %s", scarp_status_text(status));
    return CLI_USAGE;
}

static int write_shader(const struct scarp_recipe *recipe, const struct shader_options *options)
{
    const struct shader_file *const file = &shader_files[options->language];
    const struct scarp_shader how = {.language = options->language,
                                     .order = (int32_t)options->order,
                                     .file = file->text,
                                     .length = file->length};
    size_t length = 0;
    enum scarp_status status = scarp_recipe_shader(recipe, &how, NULL, 0, &length);
    if (status != SCARP_ERROR_SIZE) { /* which says the length */
        return refuse(status);
    }
    char *const text = malloc(length + 1);
    if (text == NULL) {
        cli_error("recipe: no memory for a shader");
        return CLI_FAILURE;
    }
    status = scarp_recipe_shader(recipe, &how, text, length + 1, &length);
    const int exit = status == SCARP_OK ? write_file("-", text, length) : refuse(status);
    free(text);
    return exit;
}

static int write_uniforms(const struct scarp_recipe *recipe, const char *path)
{
    static uint64_t bytes[1 << 14];
    size_t size = 0;
    const enum scarp_status status = scarp_recipe_uniforms(recipe, bytes, sizeof bytes, &size);
    return status == SCARP_OK ? write_file(path, bytes, size) : refuse(status);
}

static int write_answers(const struct scarp_recipe *recipe, int order, const char *path)
{
    static uint32_t answers[SCARP_GPU_ANSWERS];
    const enum scarp_status status = scarp_recipe_answers(recipe, order, answers);
    return status == SCARP_OK ? write_file(path, answers, sizeof answers) : refuse(status);
}

int shader_write(const struct scarp_recipe *recipe, const struct shader_options *options)
{
    int status = CLI_SUCCESS;
    if (options->uniforms != NULL) {
        status = write_uniforms(recipe, options->uniforms);
    }
    if (status == CLI_SUCCESS && options->answers != NULL) {
        status = write_answers(recipe, (int)options->order, options->answers);
    }
    if (status == CLI_SUCCESS && options->language >= 0) {
        status = write_shader(recipe, options);
    }
    return status;
}
