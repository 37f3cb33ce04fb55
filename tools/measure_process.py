#!/usr/bin/env python3
"""Runs a command and prints one line of JSON: seconds on the wall and on the processor, peak memory in MiB.

usage: measure_process.py COMMAND ARGUMENTS...

PSS (pages that n processes share count 1/n) is sampled; the greatest resident set is the kernel's own note. One process:
children of it are not looked at. Exit code: the command's.
"""
import json
import os
import subprocess
import sys
import threading
import time

LEAST_REST_SECONDS = 0.01


def pss_mib(pid):
    """What the process holds now; 0 where it is gone."""
    try:
        with open(f"/proc/{pid}/smaps_rollup") as lines:
            return next((int(line.split()[1]) / 1024 for line in lines if line.startswith("Pss:")), 0.0)
    except OSError:
        return 0.0


class Sampler(threading.Thread):
    """Notes the peak until told to stop; a reading holds the process up, so that most of the time nobody looks."""

    def __init__(self, pid):
        super().__init__(daemon=True)
        self.pid = pid
        self.peak = 0.0
        self.ended = threading.Event()

    def run(self):
        rest = 0.0
        while not self.ended.wait(rest):
            start = time.monotonic()
            self.peak = max(self.peak, pss_mib(self.pid))
            rest = max(LEAST_REST_SECONDS, 10 * (time.monotonic() - start))


def main():
    start = time.monotonic()
    process = subprocess.Popen(sys.argv[1:], stdout=subprocess.DEVNULL)
    sampler = Sampler(process.pid)
    sampler.start()
    _, status, usage = os.wait4(process.pid, 0)
    wall = time.monotonic() - start
    sampler.ended.set()
    sampler.join()
    print(json.dumps({
        "wall_s": round(wall, 4),
        "cpu_s": round(usage.ru_utime + usage.ru_stime, 4),
        "peak_pss_mib": round(sampler.peak, 1),
        "peak_rss_mib": round(usage.ru_maxrss / 1024, 1),
    }))
    return os.waitstatus_to_exitcode(status)


sys.exit(main())
