"""What a results file holds: all of it to compare two files, and whether what is there agrees with a whole run."""

import h5py

# Groups whose datasets all have a row per step.
STEPS = ("histories", "ledger", "solver")


def plain(value):
    """A value of an attribute or a dataset, comparable."""
    if getattr(value, "dtype", None) is not None and value.dtype.kind == "O":  # texts
        return tuple(value.ravel())
    return value.tobytes() if hasattr(value, "tobytes") else value


def read_contents(path):
    """Every dataset and attribute by name. The state to resume from has one name, whichever slot it is in."""
    contents = {}
    with h5py.File(path, "r", locking=False) as file:
        slot = f"restart/{'ab'[file['restart'].attrs['slot']]}/"

        def add(name, item):
            if name.startswith("restart"):
                if not name.startswith(slot):
                    return
                name = "restart/" + name[len(slot):]
            for key, value in item.attrs.items():
                contents[f"{name}@{key}"] = plain(value)
            if isinstance(item, h5py.Dataset):
                value = item[()]
                contents[name] = (item.shape, item.dtype.str, plain(value))

        file.visititems(add)
        for key, value in file.attrs.items():
            contents["@" + key] = plain(value)
    return contents


def list_differences(path, whole):
    """Names of what differs between a file and the contents of another, to the last bit."""
    try:
        contents = read_contents(path)
    except (OSError, RuntimeError, TypeError, ValueError, KeyError) as error:
        return [f"what cannot be read: {error}"]
    return sorted(name for name in contents.keys() | whole.keys() if contents.get(name) != whole.get(name))


def count_steps(path):
    """Steps that a file says it has; None if it cannot be read."""
    try:
        with h5py.File(path, "r", locking=False) as file:
            return len(file["histories/time"])
    except (OSError, KeyError, RuntimeError):
        return None  # a file that is not whole, or not yet


def is_complete(path):
    """Whether a file says that its run has come to its end."""
    try:
        with h5py.File(path, "r", locking=False) as file:
            return file.attrs["status"] == "complete"
    except (OSError, KeyError, RuntimeError):
        return False  # it is being written


def find_fault(path, whole_path):
    """Says what is wrong with the steps and frames that a file says it has, or "": they must be those of a whole run."""
    with h5py.File(path, "r", locking=False) as file, h5py.File(whole_path, "r", locking=False) as whole:
        steps = len(file["histories/time"])
        frames = len(file["VTKHDF/Steps/Values"])
        if file["VTKHDF/Steps"].attrs["NSteps"] < frames:
            return "more times of frames than frames"
        names = []
        file.visititems(lambda name, item: names.append(name) if isinstance(item, h5py.Dataset) else None)
        for name in names:
            group = name.split("/")[0]
            if group in STEPS:
                rows = steps
            elif name.startswith("VTKHDF/") and whole[name].maxshape[0] is not None:
                if file[name][()].tobytes() != whole[name][()].tobytes():
                    return f"{name} differs"
                continue
            elif name.startswith(("VTKHDF/PointData", "VTKHDF/CellData", "VTKHDF/Points")):
                rows = frames * (len(whole[name]) // len(whole["VTKHDF/Steps/Values"]))
            elif name.startswith("VTKHDF/Steps"):
                rows = frames
            else:
                continue
            if len(file[name]) < rows:
                return f"{name} has {len(file[name])} rows, {rows} are promised"
            # The last frame of a run that ended early can be of a step that is not a frame of the whole run.
            if group not in STEPS:
                rows -= rows // max(frames, 1)
            if file[name][:rows].tobytes() != whole[name][:rows].tobytes():
                return f"{name} differs"
    return ""
