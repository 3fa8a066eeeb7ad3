"""The seal of a results file: a checksum of all bytes after it, before the HDF5 file."""

import struct
import zlib

BLOCK = 512
PAGE = 4096
MAGIC = b"gxrod\r\n\x1a"


def doubt_of(path):
    """A clause on why a results file is not trusted; "" if it is, or while a run changes it."""
    with open(path, "rb") as file:
        block = file.read(BLOCK)
        if block[:8] != MAGIC:
            return "it has no seal of gxrod, so that changes to it would not be noticed"
        _, form, state, size, wanted, _ = struct.unpack("<8sI4sQII", block[:32])
        if state == b"OPEN":
            return ""
        sums, left = [], size - BLOCK
        while left > 0 and (page := file.read(min(PAGE, left))):
            sums.append(zlib.crc32(page))
            left -= len(page)
        is_kept = (form == 1 and state == b"SEAL" and left == 0 and not any(block[28:])
                   and zlib.crc32(struct.pack(f"<{len(sums)}I", *sums)) == wanted)
        file.seek(0)
        # A run that changes the file changes the seal first.
        return "" if is_kept or file.read(BLOCK) != block else "not all of its bytes are those that were written"
