// Preloaded into a program: counts what it does to the files of one folder, and at a given count kills it or fills
// the disk. The count is shared with the program's children.
//
//   CRASH_FOLDER   only files in it count
//   CRASH_COUNTER  a file of 8 bytes, mapped by all processes
//   CRASH_LOG      optional: one line for each act, "write /path"; before a rename, "from /path"
//   CRASH_KILL_AT  SIGKILL at this act, in the middle if it writes; 0 never
//   CRASH_FULL_AT  from this act on nothing can be written (ENOSPC); 0 never
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/sendfile.h>
#include <sys/syscall.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

static const char* folder;
static _Atomic long* counter;
static long kill_at, full_at;
static int log_descriptor = -1;

__attribute__((constructor)) static void begin(void) {
  const char* file = getenv("CRASH_COUNTER");
  folder = getenv("CRASH_FOLDER");
  if (!file || !folder) return;
  const int descriptor = (int)syscall(SYS_openat, AT_FDCWD, file, O_RDWR | O_CLOEXEC);
  void* memory = mmap(NULL, sizeof *counter, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
  if (memory == MAP_FAILED) abort();
  counter = memory;
  if (getenv("CRASH_KILL_AT")) kill_at = atol(getenv("CRASH_KILL_AT"));
  if (getenv("CRASH_FULL_AT")) full_at = atol(getenv("CRASH_FULL_AT"));
  if (getenv("CRASH_LOG"))
    log_descriptor = (int)syscall(SYS_openat, AT_FDCWD, getenv("CRASH_LOG"), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0600);
}

enum outcome { go_on, die, disk_full };

static int counts(const char* path) { return counter && strncmp(path, folder, strlen(folder)) == 0; }

static void note(const char* what, const char* path) {
  char line[PATH_MAX + 64];
  const int length = snprintf(line, sizeof line, "%s %s\n", what, path);
  if (log_descriptor >= 0 && counts(path)) syscall(SYS_write, log_descriptor, line, length);
}

// One act on a file. A full disk still takes names away and gives them.
static enum outcome act(const char* what, const char* path, int writes) {
  if (!counts(path)) return go_on;
  const long now = atomic_fetch_add(counter, 1) + 1;
  note(what, path);
  if (now == kill_at) return die;
  return writes && full_at > 0 && now >= full_at ? disk_full : go_on;
}

static void absolute(int from, const char* path, char* result) {
  char base[PATH_MAX] = "";
  if (path[0] != '/') {
    char link[64];
    if (from == AT_FDCWD) {
      if (!getcwd(base, sizeof base)) base[0] = '\0';
    } else {
      snprintf(link, sizeof link, "/proc/self/fd/%d", from);
      const ssize_t length = readlink(link, base, sizeof base - 1);
      base[length > 0 ? length : 0] = '\0';
    }
    strncat(base, "/", sizeof base - strlen(base) - 1);
  }
  snprintf(result, PATH_MAX, "%s", base);
  strncat(result, path, PATH_MAX - strlen(result) - 1);
}

static enum outcome act_at(const char* what, int from, const char* path) {
  char whole[PATH_MAX];
  absolute(from, path, whole);
  const enum outcome outcome = act(what, whole, 0);
  if (outcome == die) raise(SIGKILL);
  return outcome;
}

static enum outcome act_on(const char* what, int descriptor, int writes) {
  char whole[PATH_MAX];
  absolute(descriptor, "", whole);
  whole[strlen(whole) - 1] = '\0';
  return act(what, whole, writes);
}

#define NEXT(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

static int for_writing(int flags) { return (flags & O_ACCMODE) != O_RDONLY || (flags & O_CREAT); }

#define OPEN(name, parameters, arguments, from)                    \
  int name parameters {                                            \
    mode_t mode = 0;                                               \
    if (flags & O_CREAT) {                                         \
      va_list rest;                                                \
      va_start(rest, flags);                                       \
      mode = va_arg(rest, mode_t);                                 \
      va_end(rest);                                                \
    }                                                              \
    if (for_writing(flags)) act_at("open", from, path);            \
    return NEXT(name) arguments;                                   \
  }
OPEN(open, (const char* path, int flags, ...), (path, flags, mode), AT_FDCWD)
OPEN(open64, (const char* path, int flags, ...), (path, flags, mode), AT_FDCWD)
OPEN(openat, (int at, const char* path, int flags, ...), (at, path, flags, mode), at)
OPEN(openat64, (int at, const char* path, int flags, ...), (at, path, flags, mode), at)

#define FOPEN(name)                                                \
  FILE* name(const char* path, const char* mode) {                 \
    if (strpbrk(mode, "wa+")) act_at("open", AT_FDCWD, path);      \
    return NEXT(name)(path, mode);                                 \
  }
FOPEN(fopen)
FOPEN(fopen64)

// Torn: half of it is there when the program dies.
#define WRITE(name, parameters, half, whole)                       \
  ssize_t name parameters {                                        \
    const enum outcome outcome = act_on("write", descriptor, 1);   \
    if (outcome == die) {                                          \
      NEXT(name) half;                                             \
      raise(SIGKILL);                                              \
    }                                                              \
    if (outcome == disk_full) {                                    \
      errno = ENOSPC;                                              \
      return -1;                                                   \
    }                                                              \
    return NEXT(name) whole;                                       \
  }
WRITE(write, (int descriptor, const void* from, size_t count), (descriptor, from, count / 2), (descriptor, from, count))
WRITE(pwrite, (int descriptor, const void* from, size_t count, off_t at), (descriptor, from, count / 2, at),
      (descriptor, from, count, at))
WRITE(pwrite64, (int descriptor, const void* from, size_t count, off64_t at), (descriptor, from, count / 2, at),
      (descriptor, from, count, at))
WRITE(writev, (int descriptor, const struct iovec* from, int count), (descriptor, from, count / 2),
      (descriptor, from, count))
WRITE(sendfile, (int descriptor, int in, off_t* at, size_t count), (descriptor, in, at, count / 2),
      (descriptor, in, at, count))
WRITE(sendfile64, (int descriptor, int in, off64_t* at, size_t count), (descriptor, in, at, count / 2),
      (descriptor, in, at, count))

#define ON_DESCRIPTOR(name, parameters, arguments)                 \
  int name parameters {                                            \
    if (act_on(#name, descriptor, 0) == die) raise(SIGKILL);       \
    return NEXT(name) arguments;                                   \
  }
ON_DESCRIPTOR(fsync, (int descriptor), (descriptor))
ON_DESCRIPTOR(fdatasync, (int descriptor), (descriptor))
ON_DESCRIPTOR(ftruncate, (int descriptor, off_t size), (descriptor, size))
ON_DESCRIPTOR(ftruncate64, (int descriptor, off64_t size), (descriptor, size))

#define ON_PATH(name, parameters, arguments, from, path)           \
  int name parameters {                                            \
    act_at(#name, from, path);                                     \
    return NEXT(name) arguments;                                   \
  }
#define RENAME(name, parameters, arguments, from, at)              \
  int name parameters {                                            \
    char whole[PATH_MAX];                                          \
    absolute(from, old, whole);                                    \
    note("from", whole);                                           \
    act_at("rename", at, path);                                    \
    return NEXT(name) arguments;                                   \
  }
RENAME(rename, (const char* old, const char* path), (old, path), AT_FDCWD, AT_FDCWD)
RENAME(renameat, (int from, const char* old, int at, const char* path), (from, old, at, path), from, at)

ON_PATH(link, (const char* old, const char* path), (old, path), AT_FDCWD, path)
ON_PATH(linkat, (int from, const char* old, int at, const char* path, int flags), (from, old, at, path, flags), at, path)
ON_PATH(unlink, (const char* path), (path), AT_FDCWD, path)
ON_PATH(unlinkat, (int at, const char* path, int flags), (at, path, flags), at, path)
ON_PATH(remove, (const char* path), (path), AT_FDCWD, path)
ON_PATH(mkdir, (const char* path, mode_t mode), (path, mode), AT_FDCWD, path)
ON_PATH(rmdir, (const char* path), (path), AT_FDCWD, path)
