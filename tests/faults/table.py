"""The table of docs/reliability.md, from what a campaign has counted."""

import json

# What is promised, and how it is tried.
ROWS = {
    "kill": ("`kill -9`", "every step that the file counts is complete and right; `gxrod resume` continues to the last bit",
             "at a random moment of a run, its start and end included"),
    "kill_in_write": ("`kill -9` within writing", "the same", "before the n-th call that changes a file, n over all calls of a run"),
    "torn_write": ("`kill -9` in the middle of a write", "the same", "the n-th call writes some of its pages of memory, then the process is killed, as the system does it"),
    "kill_resumed": ("`kill -9` of a resumed run", "the same", "at a random moment of a run, and again of the `gxrod resume` that continues it"),
    "sigterm": ("SIGTERM", "the run ends after the current step, exit code 130", "at a random moment"),
    "ctrl_c_twice": ("Ctrl-C twice", "the run ends at once, as if killed, unless it has ended after the current step", "at a random moment, 0 to 10 ms between the two"),
    "disk_full": ("full disk", "exit code 4 and how to resume; what was written stays", "from the n-th call on, every call that needs space fails"),
    "small_disk": ("a disk that another program fills up", "the same", "a disk in memory (tmpfs), full from a random moment of the run on"),
    "disk_full_once": ("disk full for a moment", "the same, or the write is repeated", "the n-th call alone fails"),
    "file_size_limit": ("limit on the size of files", "as a full disk", "`RLIMIT_FSIZE` anywhere below what is needed"),
    "io_error": ("failing device", "as a full disk", "the n-th call alone fails with an input/output error"),
    "short_writes": ("writes that are cut short or interrupted", "no effect", "every call writes half, every third is interrupted first"),
    "read_only": ("read-only folder or file", "exit code 4; nothing is created or changed", "a run into such a folder, `gxrod resume` of such a file"),
    "removed": ("results file removed while it is written", "the run ends within a write (0.2 s), exit code 4", "at a random moment"),
    "moved": ("results file moved while it is written", "it is complete under its new name; exit code 4 says so", "at a random moment"),
    "locked": ("two writers of a file", "the second is refused, exit code 4; the first is not disturbed",
               "`gxrod resume` and `gxrod run --force` during a run, and while another program has the file locked"),
    "memory_limit": ("too little memory",
                     "exit code 2 if the deck alone shows it, with the memory needed, or if there is too little to read its mesh; else 1, or 4 from reading or writing a file, and a sentence that says so; what was written stays",
                     "`RLIMIT_AS` anywhere between loading the program and what the run needs"),
    "allocation": ("an allocation that fails", "the same", "the n-th allocation of a run, and up to all after it, but for those within HDF5"),
    "clock_jumps": ("leaps of the wall clock", "no effect: not a bit of the results depends on it", "it leaps by up to three years whenever it is asked, in a run, and in one killed halfway and its `gxrod resume`"),
    "truncated": ("a results file that is cut short", "`resume`, `export`, `report` and `gxrod-plot` say so and change nothing",
                  "cut at a random length"),
    "flipped": ("a bit of a results file that changed", "`export` and `report` say that the file is in doubt; `resume` refuses and changes nothing",
                "one bit of the file, half of them anywhere, half in what HDF5 keeps of its own, of a run that was killed at a random moment, but not within a write, or has ended"),
    "kill_batch": ("`kill -9` of a batch", "no row of its table is lost; the same command completes the same table and results",
                   "its first process, at a random moment"),
    "kill_worker": ("`kill -9` of a worker of a batch", "the batch runs its case again by itself", "one of two workers, at a random moment"),
}


def write_table(record):
    lines = ["| fault | promised | tried how | tried | lost |", "|---|---|---|---:|---:|"]
    for name, (fault, promise, trial) in ROWS.items():
        counts = record[name]
        lines.append(f"| {fault} | {promise} | {trial} | {counts['tried']} | {counts['lost']} |")
    return "\n".join(lines) + "\n"


def read_record(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)
