"""A virtual screen with the window on it, driven as a person drives it: by mouse and keys."""

import ctypes
import json
import os
import shutil
import signal
import subprocess
import tempfile
import time
import zlib
from pathlib import Path

import pictures

NEEDED = ("Xvfb", "xdotool")
PATIENCE = float(os.environ.get("TORRANCE_PATIENCE", 120))  # seconds that anything may take on a machine that is busy with something else


def missing():
    return [name for name in NEEDED if not shutil.which(name)]


class Screen:
    """Xvfb of its own, on a display number that it chooses."""

    def __init__(self, width=1000, height=700):
        self.height = height
        self.folder = tempfile.TemporaryDirectory(prefix="torrance-view-")
        read, write = os.pipe()
        self.process = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", f"{width}x{height}x24", "-fbdir", self.folder.name,
             "-nolisten", "tcp", "-noreset"],  # what the root window holds stays when nobody is connected
            pass_fds=[write], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as pipe:
            self.display = ":" + pipe.readline().strip()
        assert self.display != ":", "Xvfb did not start"

    def picture(self):
        return pictures.read_screen(Path(self.folder.name) / "Xvfb_screen0")

    def close(self):
        self.process.terminate()
        self.process.wait()
        self.folder.cleanup()


def set_dots_per_inch(screen, dots):
    """As a desktop tells its programs."""
    x11 = ctypes.CDLL("libX11.so.6")
    x11.XOpenDisplay.restype = ctypes.c_void_p
    x11.XDefaultRootWindow.restype = x11.XInternAtom.restype = ctypes.c_ulong
    display = ctypes.c_void_p(x11.XOpenDisplay(screen.display.encode()))
    text = f"Xft.dpi:\t{dots}\n".encode()
    string_type, replace = ctypes.c_ulong(31), 0
    x11.XChangeProperty(display, ctypes.c_ulong(x11.XDefaultRootWindow(display)),
                        ctypes.c_ulong(x11.XInternAtom(display, b"RESOURCE_MANAGER", 0)), string_type, 8, replace, text, len(text))
    x11.XCloseDisplay(display)


def with_layers(program, names):
    """The environment that has the Vulkan loader put these layers of the tests between the program and what it is asked
    for already."""
    # TORRANCE_TEST_PRESENT=1: each window's pictures are shown by present_layer.cpp, for a device whose driver cannot on
    # this screen. It is the last: the others change what it is told.
    present = ["present"] if os.environ.get("TORRANCE_TEST_PRESENT") == "1" else []
    folders = [Path(program).parent.parent / "tests" / "layers" / f"{name}_layer" for name in [*names, *present]]
    if not folders:
        return {}
    # Where VK_LAYER_PATH is set, the loader looks nowhere else.
    path = "VK_LAYER_PATH" if "VK_LAYER_PATH" in os.environ else "VK_ADD_LAYER_PATH"

    def around(variable, before, after=()):
        return ":".join([*before, *filter(None, [os.environ.get(variable)]), *after])

    def layers(short):
        return [f"VK_LAYER_TORRANCE_{name}" for name in short]

    return {path: around(path, map(str, folders)),
            "VK_INSTANCE_LAYERS": around("VK_INSTANCE_LAYERS", layers(names), layers(present))}


class Window:
    """`torrance view`, and what it says of itself by --report."""

    def __init__(self, program, screen, arguments, folder, validation=True, layers=(), **environment):
        self.screen = screen
        self.folder = Path(folder)
        self.report_file = self.folder / "report.json"
        self.report_file.unlink(missing_ok=True)  # of a window before
        self.environment = dict(os.environ, DISPLAY=screen.display, XDG_CONFIG_HOME=str(self.folder / "config"),
                                XDG_STATE_HOME=str(self.folder / "state"), **with_layers(program, layers), **environment)
        self.errors = open(self.folder / "stderr", "w+")
        command = [program, "view", *map(str, arguments), "--report", str(self.report_file)]
        self.process = subprocess.Popen(command + ["--validation"] * validation, env=self.environment, stderr=self.errors)
        self.id = None
        self.unit = 1  # pixels of the desktop's unit

    def run_tool(self, *arguments):
        return subprocess.run(["xdotool", *map(str, arguments)], env=self.environment, check=True, text=True,
                              stdout=subprocess.PIPE).stdout

    def report(self):
        try:
            return json.loads(self.report_file.read_text())
        except FileNotFoundError:
            return {}

    def wait_for(self, holds, what):
        """The first report that `holds` accepts."""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            report = self.report()
            if report and holds(report):
                return report
            if self.process.poll() is not None:
                raise AssertionError(f"the window closed while waiting for: {what}\n{self.said()}")
            time.sleep(0.02)
        raise AssertionError(f"waited in vain for: {what}\n{json.dumps(self.report(), indent=1)[:4000]}\n{self.said()}")

    def said(self):
        self.errors.flush()
        return Path(self.errors.name).read_text()

    def wait_open(self, scene):
        report = self.wait_for(lambda r: r.get("scene") == str(scene) and not r["opening"], f"{scene} to open")
        if self.id is None:
            self.id = self.run_tool("search", "--name", "Torrance").split()[0]
            self.run_tool("windowfocus", self.id)
        return report

    def rest(self):
        """Waits until the window has drawn all that it wants to: its report and the screen stay what they are."""
        last, same, end = None, 0, time.monotonic() + PATIENCE
        while time.monotonic() < end:
            now = (self.report_file.read_text(), zlib.crc32(self.screen.picture().codes))
            same = same + 1 if now == last else 0
            if same == 3:
                return self.report()
            last = now
            time.sleep(0.2)
        raise AssertionError("the window does not come to rest")

    def key(self, *names):
        """Presses one after the other. GLFW takes two presses of the same key within a millisecond as one (an input
        method's echo): what must not be lost is pressed key by key, or is text."""
        self.run_tool("key", "--window", 0, *names)

    def type(self, text):
        self.run_tool("type", "--delay", 20, text)
        self.rest()

    def move(self, x, y):
        self.run_tool("mousemove", round(x), round(y))
        time.sleep(0.05)

    def place(self, name):
        """The middle of something that the panels show."""
        # What opens finds its place in its second picture, which may take its time.
        opens = name.split(".")[0] in ("entry", "browser", "error", "close")
        last, same = None, 0
        while same < (3 if opens else 1):
            now = self.wait_for(lambda r: name in r["places"], f"{name} to be there")["places"][name]
            same = same + 1 if now == last else 0
            last = now
            time.sleep(0.15)
        left, top, right, bottom = [self.unit * side for side in now]
        return (left + right) / 2, (top + bottom) / 2

    def click(self, name_or_place, button=1, count=1):
        x, y = self.place(name_or_place) if isinstance(name_or_place, str) else name_or_place
        self.move(x, y)
        for _ in range(count):
            # Pressed and let go in different pictures of the window, as a hand does.
            self.run_tool("mousedown", button)
            time.sleep(0.06)
            self.run_tool("mouseup", button)
            time.sleep(0.06)

    def drag(self, start, end, button=1, steps=6):
        self.move(*start)
        self.run_tool("mousedown", button)
        for i in range(1, steps + 1):
            self.move(start[0] + (end[0] - start[0]) * i / steps, start[1] + (end[1] - start[1]) * i / steps)
        self.run_tool("mouseup", button)
        time.sleep(0.06)

    def picture_place(self, u=0.5, v=0.5):
        """A point of the scene's picture, by parts of its size."""
        x, y, width, height = self.report()["picture"]
        return x + u * width, y + v * height

    def shown(self):
        """The scene's picture as it is on the screen."""
        self.move(2, self.screen.height - 2)  # the arrow is part of the screen
        x, y, width, height = self.rest()["picture"]
        return self.screen.picture().crop(x, y, width, height)

    def quit(self):
        """Ends the window and returns its exit code."""
        if self.process.poll() is None:
            self.key("ctrl+q")
        try:
            return self.process.wait(PATIENCE)
        except subprocess.TimeoutExpired:
            self.process.send_signal(signal.SIGKILL)
            raise AssertionError("the window did not close")

    def kill(self):
        if self.process.poll() is None:
            self.process.kill()
            self.process.wait()
        self.errors.close()
