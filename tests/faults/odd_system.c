/* Preloaded, it is a system with a slow disk, without locks of files, or with a clock that goes back. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <stdlib.h>
#include <time.h>

static long number_in(const char* name) {
  const char* value = getenv(name);
  return value ? atol(value) : 0;
}

int flock(int descriptor, int operation) {
  const long reason = number_in("ODD_FLOCK_ERRNO");
  if (reason) {
    errno = (int)reason;
    return -1;
  }
  int (*real)(int, int) = (int (*)(int, int))dlsym(RTLD_NEXT, "flock");
  return real(descriptor, operation);
}

int fsync(int descriptor) {
  const long milliseconds = number_in("ODD_FSYNC_MS");
  const struct timespec pause = {milliseconds / 1000, milliseconds % 1000 * 1000000};
  nanosleep(&pause, NULL);
  int (*real)(int) = (int (*)(int))dlsym(RTLD_NEXT, "fsync");
  return real(descriptor);
}

int clock_gettime(clockid_t clock, struct timespec* now) {
  static long back = 0;
  int (*real)(clockid_t, struct timespec*) = (int (*)(clockid_t, struct timespec*))dlsym(RTLD_NEXT, "clock_gettime");
  const int failure = real(clock, now);
  if (clock == CLOCK_REALTIME) now->tv_sec -= back += number_in("ODD_CLOCK_BACK_S");
  return failure;
}
