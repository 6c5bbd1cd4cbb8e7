#include "meshing/gmsh/confinement.hpp"

#include <fcntl.h>
#include <linux/landlock.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>

namespace dda {
namespace {

/// Every right over files that this version of Landlock knows: 13 in the first, and those that came later.
std::uint64_t rights_of(long version) {
  const int bits = version >= 5 ? 16 : version >= 3 ? 15 : version == 2 ? 14 : 13;
  return (std::uint64_t{1} << bits) - 1;
}

void allow_below(int rules, const std::filesystem::path& folder) {
  landlock_path_beneath_attr below{};
  below.allowed_access = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
  below.parent_fd = open(folder.c_str(), O_PATH | O_CLOEXEC);
  if (below.parent_fd < 0) return;
  syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &below, 0);
  close(below.parent_fd);
}

void keep_to(const std::vector<std::filesystem::path>& folders) {
  const long version = syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
  if (version < 1) return;
  landlock_ruleset_attr attributes{};
  attributes.handled_access_fs = rights_of(version);
  const int rules = static_cast<int>(
      syscall(SYS_landlock_create_ruleset, &attributes, sizeof attributes.handled_access_fs, 0));
  if (rules < 0) return;
  for (const auto& folder : folders) allow_below(rules, folder);
  syscall(SYS_landlock_restrict_self, rules, 0);
  close(rules);
}

/// What memory, time, threads, reading and ending need; nothing that names another process or host.
constexpr const char* calls[] = {"access",
                                 "brk",
                                 "clock_getres",
                                 "clock_gettime",
                                 "clock_nanosleep",
                                 "close",
                                 "dup",
                                 "exit",
                                 "exit_group",
                                 "faccessat",
                                 "faccessat2",
                                 "fstat",
                                 "fstatfs",
                                 "futex",
                                 "getcpu",
                                 "getcwd",
                                 "getdents64",
                                 "getegid",
                                 "geteuid",
                                 "getgid",
                                 "getpid",
                                 "getppid",
                                 "getrandom",
                                 "getrlimit",
                                 "getrusage",
                                 "gettid",
                                 "gettimeofday",
                                 "getuid",
                                 "lseek",
                                 "lstat",
                                 "madvise",
                                 "membarrier",
                                 "mmap",
                                 "mprotect",
                                 "mremap",
                                 "munmap",
                                 "nanosleep",
                                 "newfstatat",
#ifdef __SANITIZE_ADDRESS__
                                 "pipe2",  // by which sanitizers ask whether memory can be read
#endif
                                 "poll",
                                 "ppoll",
                                 "pread64",
                                 "read",
                                 "readlink",
                                 "readlinkat",
                                 "readv",
                                 "restart_syscall",
                                 "rseq",
                                 "rt_sigaction",
                                 "rt_sigprocmask",
                                 "rt_sigreturn",
                                 "sched_getaffinity",
                                 "sched_yield",
                                 "set_robust_list",
                                 "sigaltstack",
                                 "stat",
                                 "statfs",
                                 "statx",
                                 "sysinfo",
                                 "time",
                                 "times",
                                 "uname",
                                 "write",
                                 "writev"};

/// Threads but no processes, files to read but not to write, signals to oneself.
void allow_by_argument(scmp_filter_ctx filter) {
  constexpr scmp_datum_t writes = O_WRONLY | O_RDWR | O_CREAT | O_TRUNC | O_APPEND;
  seccomp_rule_add(filter, SCMP_ACT_ALLOW, SCMP_SYS(open), 1, SCMP_A1(SCMP_CMP_MASKED_EQ, writes, 0));
  seccomp_rule_add(filter, SCMP_ACT_ALLOW, SCMP_SYS(openat), 1, SCMP_A2(SCMP_CMP_MASKED_EQ, writes, 0));
  seccomp_rule_add(filter, SCMP_ACT_ALLOW, SCMP_SYS(clone), 1,
                   SCMP_A0(SCMP_CMP_MASKED_EQ, CLONE_THREAD, CLONE_THREAD));
  seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(clone3), 0);  // glibc then takes clone
  seccomp_rule_add(filter, SCMP_ACT_ALLOW, SCMP_SYS(prlimit64), 1, SCMP_A2(SCMP_CMP_EQ, 0));
  seccomp_rule_add(filter, SCMP_ACT_ALLOW, SCMP_SYS(tgkill), 1,
                   SCMP_A0(SCMP_CMP_EQ, static_cast<scmp_datum_t>(getpid())));
}

void keep_to_calls() {
  const scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ERRNO(EPERM));
  if (!filter) return;
  for (const char* name : calls)
    if (const int call = seccomp_syscall_resolve_name(name); call != __NR_SCMP_ERROR)
      seccomp_rule_add(filter, SCMP_ACT_ALLOW, call, 0);
  allow_by_argument(filter);
  seccomp_load(filter);
  seccomp_release(filter);
}

}  // namespace

void confine(const std::vector<std::filesystem::path>& folders) {
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  keep_to(folders);
  keep_to_calls();
}

}  // namespace dda
