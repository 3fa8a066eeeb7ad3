#pragma once

#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "tools/catch.hpp"

// A process that writes a results file, and what its file is like at each moment.
namespace gxrod::test {

inline int wait_for(pid_t child) {
    int status = 0;
    ::waitpid(child, &status, 0);
    return status;
}

// Runs `action` in a child process that ends by _exit with what it returns.
template <class Action>
pid_t run_child(Action&& action) {
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) ::_exit(action());
    return child;
}

// Exit status of a child that may not be traced.
constexpr int exit_not_allowed = 77;

inline bool may_be_traced() { return ::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) == 0; }

enum class TraceEnd { not_allowed, ended_well, ended_badly, left_off };

// Stops a child, which has asked to be traced and raised SIGSTOP, before each system call that writes, and
// calls `look`; where that returns false, kills it.
template <class Look>
TraceEnd trace_writes(pid_t child, Look&& look) {
    int status = wait_for(child);
    if (WIFEXITED(status) && WEXITSTATUS(status) == exit_not_allowed) return TraceEnd::not_allowed;
    REQUIRE(WIFSTOPPED(status));
    ::ptrace(PTRACE_SETOPTIONS, child, nullptr, PTRACE_O_TRACESYSGOOD | PTRACE_O_EXITKILL);
    while (true) {
        REQUIRE(::ptrace(PTRACE_SYSCALL, child, nullptr, nullptr) == 0);
        status = wait_for(child);
        if (!WIFSTOPPED(status)) break;
        __ptrace_syscall_info call;
        if (::ptrace(PTRACE_GET_SYSCALL_INFO, child, sizeof call, &call) <= 0) continue;
        const bool writes = call.op == PTRACE_SYSCALL_INFO_ENTRY &&
                            (call.entry.nr == SYS_pwrite64 || call.entry.nr == SYS_ftruncate);
        if (!writes || look()) continue;
        ::kill(child, SIGKILL);
        wait_for(child);
        return TraceEnd::left_off;
    }
    return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? TraceEnd::ended_well : TraceEnd::ended_badly;
}

}  // namespace gxrod::test
