"""Bits of what HDF5 keeps of its own in a results file, changed one by one before `gxrod resume`."""

import dataclasses
import subprocess

import h5py

import results
from bench import Trial, describe_end


def find_own_bytes(path):
    """Places in a file of what HDF5 keeps of its own, a small part of it: what lies outside of the chunks of rows and
    is not 0."""
    content = bytearray(path.read_bytes())

    def clear_chunks(_, item):
        if isinstance(item, h5py.Dataset) and item.chunks:
            for i in range(item.id.get_num_chunks()):
                chunk = item.id.get_chunk_info(i)
                content[chunk.byte_offset:chunk.byte_offset + chunk.size] = bytes(chunk.size)

    try:
        with h5py.File(path, locking=False) as file:
            file.visititems(clear_chunks)
    except OSError:
        pass  # killed before it was a file of HDF5's
    return [at for at, byte in enumerate(content) if byte]


def flip_bit(content, bit):
    changed = bytearray(content)
    changed[bit // 8] ^= 1 << bit % 8
    return changed


@dataclasses.dataclass(frozen=True)
class Base:
    """A file, how it is gone on from, and what it holds then if nothing is wrong with it."""
    content: bytes
    own_bytes: list
    changes: list
    end: dict


def make_base(bench, deck, changes):
    path = bench.path(deck)
    content, own_bytes = path.read_bytes(), find_own_bytes(path)
    done = bench.run("resume", path.name, "--threads", deck.threads, *changes)
    if done.returncode != 0:
        raise RuntimeError(f"{deck.name} is not gone on from: {done.stderr}")
    return Base(content, own_bytes, changes, results.read_contents(path))


def is_sealed(path):
    with h5py.File(path, locking=False) as file:
        return file["restart/checksum_of_file"][0] >= 0


def kill_between_writes(bench, deck):
    """Halfway: in the midst of a write the file has no checksum of all its bytes."""
    calls = bench.count_calls(deck, "FAULT_LOG", CLOCK_TICK=deck.tick)
    for at in range(calls // 2, calls):
        bench.run(*bench.arguments(deck), "--quiet",
                  environment=bench.environment(FAULT="kill", FAULT_AT=at, CLOCK_TICK=deck.tick))
        if is_sealed(bench.path(deck)):
            return
    raise RuntimeError(f"{deck.name} is never between two writes")


def find_bases(bench, deck):
    """Files of a run that was killed halfway and, if the deck can last longer, of one that has ended."""
    if deck.name not in bench.bases:
        kill_between_writes(bench, deck)
        bases = [make_base(bench, deck, [])]
        if deck.later:
            bench.run(*bench.arguments(deck), "--quiet", environment=bench.environment(CLOCK_TICK=deck.tick))
            bases.append(make_base(bench, deck, [word for change in deck.later for word in ("--set", change)]))
        bench.bases[deck.name] = bases
    return bench.bases[deck.name]


def count_own_bits(bench, deck):
    return sum(8 * len(base.own_bytes) for base in find_bases(bench, deck))


def flip_own_bit(bench, deck, at):
    """The at-th bit is another one. `gxrod resume` refuses to go on, or goes on to the last bit. (It can be called by
    several threads.)"""
    number = at - 1
    for base in find_bases(bench, deck):
        if number < 8 * len(base.own_bytes):
            break
        number -= 8 * len(base.own_bytes)
    bit = 8 * base.own_bytes[number // 8] + number % 8
    path = bench.folder / f"{deck.name}_{at}.vtkhdf"
    path.write_bytes(flip_bit(base.content, bit))
    what = f"{deck.name}, {'ended' if base.changes else 'killed'}, bit {bit}"
    try:
        done = bench.run("resume", path.name, "--threads", deck.threads, *base.changes)
        trial = Trial(describe_end(done.returncode), "resumed" if done.returncode == 0 else "refused")
        if done.returncode == 0:
            differences = results.list_differences(path, base.end)
            trial.lost = f"{what}: differs in {', '.join(differences[:5])}" if differences else ""
        elif done.returncode != 4 or path.name not in done.stderr:
            trial.lost = f"{what}: told as: {done.stderr[-500:]}"
        elif path.read_bytes() != flip_bit(base.content, bit):
            trial.lost = f"{what}: the file was changed and then told as: {done.stderr[-500:]}"
    except subprocess.TimeoutExpired:
        trial = Trial("no end", "", lost=f"{what}: does not end")
    path.unlink()
    return trial
