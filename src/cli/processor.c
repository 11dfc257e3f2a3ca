/* Refuses to start on a processor that lacks instructions this program is made of, and lets the program for AVX-512 that may lie
   beside it start in its place (tools/cmake/avx512.cmake). The constructor runs before those of C++; this file is compiled for every
   processor of the family (src/CMakeLists.txt). */
#if defined(__x86_64__)

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* What the compiler was allowed to use; ends with NULL (processor_needs.cpp). */
extern const char* const softwet_processor_needs[];

static int has(const char* name) {
#define KNOWS(feature) \
  if (strcmp(name, feature) == 0) return __builtin_cpu_supports(feature) != 0
  KNOWS("sse3");
  KNOWS("ssse3");
  KNOWS("sse4.1");
  KNOWS("sse4.2");
  KNOWS("popcnt");
  KNOWS("avx");
  KNOWS("avx2");
  KNOWS("fma");
  KNOWS("fma4");
  KNOWS("xop");
  KNOWS("bmi");
  KNOWS("bmi2");
  KNOWS("gfni");
  KNOWS("avx512f");
  KNOWS("avx512cd");
  KNOWS("avx512bw");
  KNOWS("avx512dq");
  KNOWS("avx512vl");
  KNOWS("avx512ifma");
  KNOWS("avx512vbmi");
  KNOWS("avx512vbmi2");
  KNOWS("avx512vnni");
  KNOWS("avx512bitalg");
  KNOWS("avx512vpopcntdq");
#undef KNOWS
  return 1;
}

/* Goes on as PROGRAM-x86-64-v4, where there is such a file and the processor knows its instructions; SOFTWET_AVX512=0 forbids
   it. Returns where there is none. */
static void become_wider(char** argv) {
  static const char suffix[] = "-x86-64-v4";
  static const char* const needs[] = {"avx512f", "avx512bw", "avx512cd", "avx512dq", "avx512vl", NULL};
  const char* wanted = getenv("SOFTWET_AVX512");
  if (wanted && strcmp(wanted, "0") == 0) return;
  for (const char* const* name = needs; *name; ++name)
    if (!has(*name)) return;
  char path[4096];
  const ssize_t length = readlink("/proc/self/exe", path, sizeof path - sizeof suffix);
  if (length <= 0 || length >= (ssize_t)(sizeof path - sizeof suffix)) return;
  memcpy(path + length, suffix, sizeof suffix);
  execv(path, argv);
}

__attribute__((constructor(101))) static void require_processor(int argc, char** argv) {
  char missing[256] = "", text[640];
  __builtin_cpu_init();
  if (argc > 0) become_wider(argv);
  for (const char* const* name = softwet_processor_needs; *name; ++name) {
    if (has(*name) || strlen(missing) + strlen(*name) + 2 > sizeof missing) continue;
    if (missing[0]) strcat(missing, " ");
    strcat(missing, *name);
  }
  if (!missing[0]) return;
  const char* portable = strstr(missing, "avx2") ? "" : ", or take one of the preset portable, which needs AVX2 only";
  const int length = snprintf(text, sizeof text,
                              "softwet: error: this softwet was built for another kind of processor: the one of this "
                              "machine lacks %s; build softwet on this machine (tools/setup)%s\n",
                              missing, portable);
  if (write(STDERR_FILENO, text, (size_t)length) < 0) _exit(3);
  _exit(3);
}

#else
typedef int softwet_no_check; /* other processors: one instruction set, that of the compiler */
#endif
