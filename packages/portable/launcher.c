// bin/kfast of the tar that needs no installation (docs/release.md): has the tar's own dynamic loader start
// the tar's kfast with the tar's own libraries. It is linked statically, so that it needs nothing but a
// kernel. The environment stays as it is: LD_LIBRARY_PATH would reach the programs that kfast starts, too.
#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/auxv.h>
#include <unistd.h>

enum { cannot_start = 127, options = 7 };

static char launcher[PATH_MAX];

/// The path of this file, without links. The kernel's note of what it started is for where there is no /proc.
static int find_launcher(void)
{
    const ssize_t length = readlink("/proc/self/exe", launcher, sizeof launcher - 1);
    if (length > 0)
        return 1;
    const char* started = (const char*)getauxval(AT_EXECFN);
    return started != NULL && realpath(started, launcher) != NULL;
}

/// `name` in the folder lib/kfast of the tar, whose folder bin has the launcher.
static const char* in_library_folder(const char* name, char* path, size_t size)
{
    char prefix[PATH_MAX];
    strcpy(prefix, launcher);
    for (int parent = 0; parent < 2; ++parent) {
        char* slash = strrchr(prefix, '/');
        if (slash != NULL)
            *slash = '\0';
    }
    const int length = snprintf(path, size, "%s/lib/kfast%s", prefix, name);
    return length < 0 || (size_t)length >= size ? NULL : path;
}

static int fail(const char* what)
{
    fprintf(stderr, "error: %s cannot be started: %s; unpack the whole tar of kfast again\n", what,
            strerror(errno));
    return cannot_start;
}

int main(int count, char** arguments)
{
    char loader[PATH_MAX];
    char libraries[PATH_MAX];
    char program[PATH_MAX];
    if (!find_launcher())
        return fail("kfast");
    errno = ENAMETOOLONG;
    if (in_library_folder("/ld.so", loader, sizeof loader) == NULL ||
        in_library_folder("", libraries, sizeof libraries) == NULL ||
        in_library_folder("/kfast", program, sizeof program) == NULL)
        return fail(launcher);

    char** words = calloc((size_t)count + options + 1, sizeof *words);
    if (words == NULL)
        return fail(launcher);
    char* const first[options] = {loader,    "--inhibit-cache", "--library-path", libraries,
                                  "--argv0", launcher,          program};
    memcpy(words, first, sizeof first);
    if (count > 1)
        memcpy(words + options, arguments + 1, (size_t)(count - 1) * sizeof *words);
    execv(loader, words);
    return fail(loader);
}
