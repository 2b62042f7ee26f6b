#!/usr/bin/python3
"""assistive.py FENESTRA LANGUAGE

Walks the window as a screen reader does, by AT-SPI: every control in sight has a name and a role, and a tick, a slider, a
choice, a tab and a menu are found by name and used. Runs on a session bus and a display of its own. Exits with 1 and says
what is missing, or with 77 where python3-pyatspi is not installed."""
import os
import subprocess
import sys
import tempfile
import time

try:
    import pyatspi
except ImportError:
    print("skipped: python3-pyatspi is not installed")
    sys.exit(77)

from gi.repository import Atspi  # pyatspi has loaded it

# By default a call waits for 0.8 s, and for 15 s while a program starts. Beside other tests the window may answer later.
Atspi.set_timeout(5_000, 15_000)

program, language = sys.argv[1:]
texts = {
    "en": {"tick": "Open the context around the focus", "slider": "Opening", "choice": "Adaptive cutaway", "tab": "Clipping", "in tab": "Crop to a box",
           "menu": "Settings…", "dialog": "Settings", "list": "Structures", "slice": "Axial"},
    "de": {"tick": "Kontext um den Fokus öffnen", "slider": "Öffnung", "choice": "Adaptiver Freischnitt", "tab": "Beschnitt", "in tab": "Auf einen Quader zuschneiden",
           "menu": "Einstellungen…", "dialog": "Einstellungen", "list": "Strukturen", "slice": "Axial"},
}[language]
patience = 600  # s; reached only when something is missing, however busy the machine is
interactive = {"push button", "check box", "radio button", "toggle button", "combo box", "slider", "spin button", "text",
               "tree", "list", "table", "tree table", "page tab", "menu item", "menu", "link"}
flaws = []


def wait_for(what, found):
    end = time.monotonic() + patience
    last = None
    while time.monotonic() < end:
        if started.poll() is not None:
            print(f"the program ended with {started.returncode} before there was {what}")
            sys.exit(1)
        try:
            result = found()
            if result:
                return result
        except Exception as error:  # the tree changes while it is read
            last = error
        time.sleep(0.2)
    print(f"not found: {what}; last error: {last!r}")
    print("on the desktop:", [(each.name, each.childCount) for each in desktop() if each])
    sys.exit(1)


def desktop():
    """As it is now: a program that was asked before its window was there would stay without one in the cache."""
    found = pyatspi.Registry.getDesktop(0)
    found.clearCache()
    return found


def below(node):
    """All that is told of a window, but the cells of lists, of which there may be thousands."""
    yield node
    if node.getRoleName() in ("tree", "table", "list", "tree table"):
        return
    for child in node:
        if child:
            yield from below(child)


def showing(node):
    return node.getState().contains(pyatspi.STATE_SHOWING)


def named(app, name, role):
    return next((node for node in below(app) if node.name == name and node.getRoleName() == role and showing(node)), None)


def use(node, wanted=("Toggle", "Press", "ShowMenu", "SetFocus")):
    action = node.queryAction()
    names = [action.getName(i) for i in range(action.nActions)]
    action.doAction(min((wanted.index(name), i) for i, name in enumerate(names) if name in wanted)[1])


scratch = tempfile.TemporaryDirectory()
environment = dict(os.environ, QT_LINUX_ACCESSIBILITY_ALWAYS_ON="1", XDG_CONFIG_HOME=scratch.name, XDG_DATA_HOME=scratch.name,
                   HOME=scratch.name)
started = subprocess.Popen([program, "--phantom", "torso", "--language", language], env=environment)
try:
    app = wait_for("the window", lambda: next((each for each in desktop() if each and each.name == "Fenestra"
                                               and each.childCount), None))
    tick = wait_for(texts["tick"], lambda: named(app, texts["tick"], "check box"))
    wait_for("enabled controls", lambda: tick.getState().contains(pyatspi.STATE_ENABLED))

    before = tick.getState().contains(pyatspi.STATE_CHECKED)
    use(tick)
    wait_for("a tick that changes", lambda: tick.getState().contains(pyatspi.STATE_CHECKED) != before)
    use(tick)
    wait_for("a tick that changes back", lambda: tick.getState().contains(pyatspi.STATE_CHECKED) == before)

    slider = wait_for(texts["slider"], lambda: named(app, texts["slider"], "slider"))
    box = wait_for(texts["slider"], lambda: named(app, texts["slider"], "spin button"))
    slider.queryValue().currentValue = slider.queryValue().currentValue + 7
    wait_for("a field that follows its slider",
             lambda: abs(box.queryValue().currentValue - slider.queryValue().currentValue) < 1e-6)

    # On Linux, Qt calls a box of choices by what is chosen, and relates it to its label.
    wait_for(texts["choice"], lambda: named(app, texts["choice"], "combo box"))
    wait_for("rows of the list", lambda: named(app, texts["list"], "tree").childCount > 20)
    wait_for(texts["slice"], lambda: next(node for node in below(app) if node.name == texts["slice"] and showing(node)
                                          and node.getRole() in (pyatspi.ROLE_IMAGE, pyatspi.ROLE_CANVAS)))

    tab = wait_for(texts["tab"], lambda: named(app, texts["tab"], "page tab"))
    seen = set()
    for round in (None, tab):
        if round:
            use(round)
            wait_for("the tab's panel", lambda: named(app, texts["in tab"], "check box"))
        for node in below(app):
            if node.getRoleName() in interactive and showing(node):
                seen.add((node.getRoleName(), node.name))
                if not node.name.strip():
                    around = [node]
                    while around[-1].parent and around[-1].parent != app:
                        around.append(around[-1].parent)
                    flaws.append(" < ".join(f"{each.getRoleName()} {each.name!r}" for each in around[:6]))
    if len(seen) < 60:
        flaws.append(f"only {len(seen)} controls were told of")

    entry = wait_for(texts["menu"], lambda: next(node for node in below(app) if node.name == texts["menu"]
                                                 and node.getRoleName() == "menu item"))
    try:
        use(entry)
    except Exception:  # Qt answers only once the dialog is closed, and AT-SPI stops waiting before
        pass
    wait_for(texts["dialog"], lambda: next(node for node in below(app) if node.name == texts["dialog"]
                                           and node.getRoleName() == "dialog" and showing(node)))
finally:
    started.terminate()
    try:
        started.wait(10)
    except subprocess.TimeoutExpired:
        started.kill()
for flaw in flaws:
    print("without a name:", flaw)
print(f"{len(seen)} controls were told of")
sys.exit(1 if flaws else 0)
