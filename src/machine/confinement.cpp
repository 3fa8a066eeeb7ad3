#include "machine/confinement.hpp"

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <vector>

// A filter of system calls (seccomp), a program for the kernel's packet filter. Its registers have 32 bits;
// of the arguments, flags all, the lower half is looked at.
namespace gxrod {
namespace {

#if defined(__x86_64__)
constexpr std::uint32_t machine = AUDIT_ARCH_X86_64;
constexpr std::uint32_t call_of_x32 = 0x40000000;  // calls of another kind, in the same numbers
#elif defined(__aarch64__)
constexpr std::uint32_t machine = AUDIT_ARCH_AARCH64;
constexpr std::uint32_t call_of_x32 = UINT32_MAX;
#else
constexpr std::uint32_t machine = 0;
constexpr std::uint32_t call_of_x32 = 0;
#endif

// Calls that start programs, and with which others are reached.
constexpr std::uint32_t deadly[] = {
#ifdef SYS_fork
    SYS_fork,
    SYS_vfork,
#endif
    SYS_execve,
    SYS_execveat,
    SYS_socket,
    SYS_ptrace,
    SYS_process_vm_writev,
    SYS_bpf,
    SYS_kill,
    SYS_tkill,
    SYS_mount,
    SYS_pidfd_send_signal};

// Calls that change files by their names: refused as if the user had no right to.
constexpr std::uint32_t refused[] = {
#ifdef SYS_fork
    SYS_creat,     SYS_rename,   SYS_unlink,   SYS_mkdir,     SYS_rmdir,     SYS_link,          SYS_symlink,
    SYS_chmod,     SYS_chown,    SYS_lchown,   SYS_mknod,
#endif
#ifdef SYS_renameat
    SYS_renameat,
#endif
    SYS_renameat2, SYS_unlinkat, SYS_mkdirat,  SYS_linkat,    SYS_symlinkat, SYS_fchmodat,      SYS_fchownat,
    SYS_mknodat,   SYS_truncate, SYS_setxattr, SYS_lsetxattr, SYS_utimensat, SYS_io_uring_setup};

class Filter {
  public:
    Filter() {
        load(offsetof(seccomp_data, arch));
        unless_equal(machine, SECCOMP_RET_KILL_PROCESS);
        load(offsetof(seccomp_data, nr));
        jump(BPF_JGE, call_of_x32, SECCOMP_RET_KILL_PROCESS);
        for (const std::uint32_t call : deadly) jump(BPF_JEQ, call, SECCOMP_RET_KILL_PROCESS);
        for (const std::uint32_t call : refused) jump(BPF_JEQ, call, SECCOMP_RET_ERRNO | EACCES);
        // Their arguments cannot be seen; callers fall back to the older calls.
        jump(BPF_JEQ, SYS_clone3, SECCOMP_RET_ERRNO | ENOSYS);
        jump(BPF_JEQ, SYS_openat2, SECCOMP_RET_ERRNO | ENOSYS);
        constexpr std::uint32_t writing = O_WRONLY | O_RDWR | O_CREAT | O_TRUNC;
        refuse_flags(SYS_openat, 2, writing);
#ifdef SYS_open
        refuse_flags(SYS_open, 1, writing);
#endif
        require_flag(SYS_clone, 0, CLONE_THREAD);
        finish(SECCOMP_RET_ALLOW);
    }

    bool install() {
        const sock_fprog program{static_cast<unsigned short>(code_.size()), code_.data()};
        return machine != 0 && ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
               ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
    }

  private:
    void add(std::uint32_t code, std::uint32_t value, std::uint8_t if_true = 0, std::uint8_t if_false = 0) {
        code_.push_back({static_cast<std::uint16_t>(code), if_true, if_false, value});
    }
    void load(std::size_t offset) { add(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offset)); }
    void finish(std::uint32_t verdict) { add(BPF_RET | BPF_K, verdict); }
    void jump(std::uint32_t comparison, std::uint32_t value, std::uint32_t verdict) {
        add(BPF_JMP | comparison | BPF_K, value, 0, 1);
        finish(verdict);
    }
    void unless_equal(std::uint32_t value, std::uint32_t verdict) {
        add(BPF_JMP | BPF_JEQ | BPF_K, value, 1, 0);
        finish(verdict);
    }
    static std::size_t argument(std::size_t index) {
        return offsetof(seccomp_data, args) + index * sizeof(std::uint64_t);
    }
    // Of one call; what follows sees its number again.
    void refuse_flags(std::uint32_t call, std::size_t index, std::uint32_t flags) {
        add(BPF_JMP | BPF_JEQ | BPF_K, call, 0, 4);
        load(argument(index));
        jump(BPF_JSET, flags, SECCOMP_RET_ERRNO | EACCES);
        finish(SECCOMP_RET_ALLOW);
    }
    void require_flag(std::uint32_t call, std::size_t index, std::uint32_t flag) {
        add(BPF_JMP | BPF_JEQ | BPF_K, call, 0, 4);
        load(argument(index));
        add(BPF_JMP | BPF_JSET | BPF_K, flag, 1, 0);
        finish(SECCOMP_RET_KILL_PROCESS);
        finish(SECCOMP_RET_ALLOW);
    }

    std::vector<sock_filter> code_;
};

}  // namespace

bool allow_reading_only() { return Filter().install(); }

}  // namespace gxrod
