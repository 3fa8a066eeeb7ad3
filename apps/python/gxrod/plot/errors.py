"""Faults that end gxrod-plot with a message and one of gxrod's exit codes."""

from ..errors import Error


class PlotError(Error):
    """Ends the program with `exit_code` and one line on stderr."""

    exit_code = 1


class UsageError(PlotError):
    """The command line asks for something that is not there."""

    exit_code = 2


class FileFault(PlotError):
    """A file could not be read or written."""

    exit_code = 4
