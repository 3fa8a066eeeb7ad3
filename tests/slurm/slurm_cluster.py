"""A Slurm of two nodes on this machine, for one test: daemons of its own, in a folder of its own, on free ports."""

import atexit
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import time

COMMANDS = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scancel", "scontrol", "sinfo")
SEARCH = os.pathsep.join([os.environ.get("PATH", ""), "/usr/sbin", "/sbin"])


def missing_commands():
    return [name for name in COMMANDS if shutil.which(name, path=SEARCH) is None]


def wait_until(condition, what, seconds=60.0, describe=lambda: ""):
    """Waits for a condition; an error says what was waited for, with the text of `describe`."""
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            raise TimeoutError(f"after {seconds} s still not: {what}\n{describe()}")
        time.sleep(0.05)


def free_ports(count):
    """Ports that nobody listens on now."""
    sockets = [socket.socket() for _ in range(count)]
    try:
        for one in sockets:
            one.bind(("127.0.0.1", 0))
        return [one.getsockname()[1] for one in sockets]
    finally:
        for one in sockets:
            one.close()


def find_processes(folder, node=None):
    """Numbers of all processes of the Slurm in a folder, its jobs included; or of the jobs on one node."""
    marks = [f"SLURM_CONF={folder}/".encode()] + ([f"SLURMD_NODENAME={node}\0".encode()] if node else [])
    found = []
    for process in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            environment = (process / "environ").read_bytes()
        except OSError:
            continue
        if all(mark in environment for mark in marks):
            found.append(int(process.name))
    return found


def parent_of(process):
    try:
        status = pathlib.Path(f"/proc/{process}/status").read_text()
    except OSError:
        return 0
    return int(next(line for line in status.splitlines() if line.startswith("PPid:")).split()[1])


def kill_all(processes):
    for process in processes:
        try:
            os.kill(process, signal.SIGKILL)
        except ProcessLookupError:
            pass


def end_all(folder):
    """Ends the Slurm in a folder, also what it starts meanwhile."""
    while processes := find_processes(folder):
        kill_all(processes)
        time.sleep(0.02)


class SlurmCluster:
    """Two nodes, n1 and n2, of two cores each. Everything it starts is ended by stop(), or when Python ends: what
    jobs run is not among its children, so a guard outside waits for that, in case it is killed."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.user = subprocess.run(["id", "-un"], stdout=subprocess.PIPE, text=True, check=True).stdout.strip()
        self.environment = {key: value for key, value in os.environ.items()
                            if not key.startswith(("SLURM", "SBATCH", "SQUEUE"))}
        self.environment |= {"PATH": SEARCH, "SLURM_CONF": str(self.folder / "slurm.conf")}
        self.daemons = {}
        self.guard = subprocess.Popen(["setsid", "--fork", sys.executable, "-B", __file__, str(self.folder)],
                                      stdin=subprocess.PIPE)
        self.guard.wait()
        atexit.register(self.stop)

    def start(self):
        for name in ("state", "spool-n1", "spool-n2"):
            (self.folder / name).mkdir(parents=True)
        self.start_munge()
        self.write_configuration()
        self.launch("slurmctld", "slurmctld", "-D", "-c")
        for node in ("n1", "n2"):
            self.start_node(node)
        self.wait_for_nodes({"n1": "idle", "n2": "idle"})

    def start_munge(self):
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o400)
        paths = {name: str(self.folder / f"munge.{name}") for name in ("socket", "pid", "log", "seed")}
        self.launch("munged", "munged", "--foreground", "--force", "--key-file", str(key), "--socket", paths["socket"],
                    "--pid-file", paths["pid"], "--log-file", paths["log"], "--seed-file", paths["seed"])
        wait_until(lambda: os.path.exists(paths["socket"]), "munged listens")

    def write_configuration(self):
        control, first, second = free_ports(3)
        (self.folder / "slurm.conf").write_text(f"""ClusterName=gxrod
SlurmctldHost=localhost
SlurmctldPort={control}
SlurmUser={self.user}
SlurmdUser={self.user}
AuthType=auth/munge
AuthInfo=socket={self.folder}/munge.socket
StateSaveLocation={self.folder}/state
SlurmdSpoolDir={self.folder}/spool-%n
SlurmctldPidFile={self.folder}/slurmctld.pid
SlurmdPidFile={self.folder}/slurmd-%n.pid
SlurmctldLogFile={self.folder}/slurmctld.log
SlurmdLogFile={self.folder}/slurmd-%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
MpiDefault=none
SwitchType=switch/none
ReturnToService=0
KillWait=5
SlurmdTimeout=300
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerType=sched/builtin
SchedulerParameters=sched_interval=1,batch_sched_delay=0,sched_min_interval=0
NodeName=n1 NodeHostname=localhost NodeAddr=127.0.0.1 Port={first} CPUs=2 RealMemory=1000 State=UNKNOWN
NodeName=n2 NodeHostname=localhost NodeAddr=127.0.0.1 Port={second} CPUs=2 RealMemory=1000 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES State=UP
""")

    def launch(self, name, *command):
        log = open(self.folder / f"{name}.out", "ab")
        self.daemons[name] = subprocess.Popen([shutil.which(command[0], path=SEARCH), *command[1:]],
                                              env=self.environment, cwd=self.folder, stdin=subprocess.DEVNULL,
                                              stdout=log, stderr=log, start_new_session=True)
        log.close()

    def start_node(self, node):
        self.launch(node, "slurmd", "-D", "-N", node)

    def kill_node(self, node):
        """As if its power failed: at once the daemon, those that watch over its jobs, and these."""
        jobs = find_processes(self.folder, node)
        watchers = {parent_of(process) for process in jobs} - set(jobs) - {0, 1}
        daemon = self.daemons.pop(node)
        daemon.kill()
        daemon.wait()
        kill_all([*watchers, *jobs])

    def revive_node(self, node):
        """Starts a node that died, if it did, and has it used again."""
        if node in self.daemons:
            return
        self.start_node(node)
        self.call("scontrol", "update", f"nodename={node}", "state=resume", check=False)
        self.wait_for_nodes({node: "idle"})

    def call(self, *command, check=True):
        done = subprocess.run(command, env=self.environment, cwd=self.folder, text=True, timeout=60,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if check and done.returncode != 0:
            raise RuntimeError(f"{command}: {done.stdout}")
        return done.stdout

    def node_states(self):
        lines = self.call("sinfo", "-h", "-N", "-o", "%N %T", check=False).split("\n")
        return dict(line.split() for line in lines if len(line.split()) == 2)

    def wait_for_nodes(self, states):
        self.wait_until(lambda: {node: state for node, state in self.node_states().items() if node in states} == states,
                        f"nodes are {states}")

    def wait_until(self, condition, what):
        wait_until(condition, what, describe=self.describe)

    def describe(self):
        """The nodes, the jobs, and the end of what the controller logged but for the updates of jobs."""
        log = (self.folder / "slurmctld.log").read_text().splitlines()
        log = [line for line in log if "update_job" not in line and "updating accounting" not in line]
        jobs = self.call("squeue", "-r", "-o", "%i %T %N %r %S", check=False)
        return "\n".join([str(self.node_states()), jobs, *log[-30:]])

    def stop(self):
        """Ends every process of this Slurm, also those that its daemons start meanwhile."""
        for daemon in self.daemons.values():
            daemon.kill()
            daemon.wait()
        self.daemons = {}
        end_all(self.folder)
        self.guard.stdin.close()
        atexit.unregister(self.stop)


if __name__ == "__main__":  # the guard
    sys.stdin.read()
    end_all(sys.argv[1])
