"""Bits of results files, those of what HDF5 keeps of its own among them."""

import h5py


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


def count_sealed_bytes(path):
    """How many bytes the seal of a file covers; 0 if a run was killed while it wrote them."""
    seal = path.read_bytes()[:24]
    return int.from_bytes(seal[16:], "little") if seal[12:16] == b"SEAL" else 0
