"""Whether pages, pictures and results.json belong together, and no case of the program is missing."""

from .cases import list_cases
from .figures import is_current, wanted_figures
from .pages import PageFault, renewed_pages

RENEW = "renew with docs/verification/make_book.py"


def find_faults(kept, program):
    """Sentences; none if all is current."""
    listed, faults = list_cases(program), []
    for name in sorted(set(listed) - set(kept["cases"])):
        faults.append(f"results.json has no {name}, which the program lists: {RENEW}")
    for name in sorted(set(kept["cases"]) - set(listed)):
        faults.append(f"results.json has {name}, which the program does not list: {RENEW}")
    if faults:
        return faults  # the rest would only say the same again
    for page, text, renewed in renewed_pages(kept):
        if isinstance(renewed, PageFault):
            faults.append(f"{page.name} {renewed}")
        elif renewed != text:
            faults.append(f"{page.name} has tables that are not those of results.json: {RENEW} --pages")
        else:
            faults += missing_figures(page, text)
    for name, kind, path, digest in wanted_figures(kept):
        if not is_current(path, digest):
            faults.append(f"figures/{path.name} of {name} is missing or not drawn from these data: {RENEW} --pages")
    return faults


def missing_figures(page, text):
    """A page of a case shows both of its pictures."""
    if page.stem == "README":
        return []
    wanted = [f"figures/{page.stem}_{kind}.png" for kind in ("sketch", "convergence")]
    return [f"{page.name} does not show {figure}" for figure in wanted if f"({figure})" not in text]
