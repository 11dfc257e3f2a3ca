/* Loaded before a program (LD_PRELOAD): memory that it allocates is full of NaN, so that numbers which are read before
   they were written cannot pass as zeros. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>

static void* filled(void* memory, size_t size) { return memory ? memset(memory, 0xff, size) : NULL; }

void* malloc(size_t size) {
  static void* (*next)(size_t);
  if (!next) next = (void* (*)(size_t))dlsym(RTLD_NEXT, "malloc");
  return filled(next(size), size);
}

void* aligned_alloc(size_t alignment, size_t size) {
  static void* (*next)(size_t, size_t);
  if (!next) next = (void* (*)(size_t, size_t))dlsym(RTLD_NEXT, "aligned_alloc");
  return filled(next(alignment, size), size);
}

int posix_memalign(void** memory, size_t alignment, size_t size) {
  static int (*next)(void**, size_t, size_t);
  if (!next) next = (int (*)(void**, size_t, size_t))dlsym(RTLD_NEXT, "posix_memalign");
  const int failed = next(memory, alignment, size);
  if (!failed) filled(*memory, size);
  return failed;
}
