# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the commands of the program on cases of a folder (SEED.ini).

usage: wide_files.py FOLDER FIRST COUNT [SECONDS]

The commands are check (text, --json, and -v, whose output must be a case with
the same numbers), run (--json or a report), info, export, and resume of a run
that was killed. Faults are

  - a signal, a report of a sanitizer, or an undocumented exit code
  - invalid JSON, or an infinite number or NaN in the output or in a field
  - a failure without an error message
  - a difference between the resumed and the uninterrupted run

Cases whose estimated time is above SECONDS are skipped. One line per case is
printed. At most one in twenty of the timed cases may take ten times the
estimate (not checked for instrumented programs).
"""
import json
import os
import re
import resource
import signal
import subprocess
import sys
import time

import h5py
import numpy

OVERROLL = os.environ.get("OVERROLL", "build/overroll")
INSTRUMENTED = bool(os.environ.get("INSTRUMENTED"))
SLOWER = 60 if INSTRUMENTED else 1
# Time in s after which runs are stopped (their exit code is 143).
PATIENCE = float(os.environ.get("OVERROLL_PATIENCE", "0")) or None
START = 0.3  # s; the cost of shorter runs is not compared
KILLED = 60 if INSTRUMENTED else 1  # s; only shorter runs are killed
MEMORY = 2 << 30
NOT_FINITE = re.compile(r"(?<![\w/-])[-+]?(nan|inf|infinity)(?![\w-])", re.I)
REPORT = re.compile(r"AddressSanitizer|UndefinedBehavior|runtime error"
                    r"|LeakSanitizer")
# Fields that must be finite at all nodes.
FIELDS = ("pressure", "film_thickness", "roughness", "x", "y", "time")


class Fault(Exception):
    pass


def limits(seconds):
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 5))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    if not INSTRUMENTED:
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


def ended(arguments, seconds, patience):
    """Runs the program and terminates it after `patience` seconds."""
    with subprocess.Popen([OVERROLL, *arguments], stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          text=True,
                          preexec_fn=lambda: limits(int(seconds) + 1)) as run:
        try:
            out, err = run.communicate(timeout=patience)
        except subprocess.TimeoutExpired:
            run.terminate()
            out, err = run.communicate()
        return subprocess.CompletedProcess(arguments, run.returncode, out, err)


def call(arguments, seconds=600, codes=(0, 2), patience=None):
    """Returns exit code (None: out of time), stdout, stderr and CPU time."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = ended(arguments, seconds, patience)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    used = (after.ru_utime + after.ru_stime
            - before.ru_utime - before.ru_stime)
    what = " ".join(arguments)
    if REPORT.search(done.stderr):
        raise Fault(f"{what}: {done.stderr}")
    code = done.returncode
    if code in (-signal.SIGXCPU, -signal.SIGKILL):
        return None, done.stdout, done.stderr, used
    if code not in codes:
        raise Fault(f"{what}: exit code {code}: {done.stderr}")
    for name, text in ("stdout", done.stdout), ("stderr", done.stderr):
        found = NOT_FINITE.search(text)
        # NaN is an undefined quantity of a table.
        if found and (arguments[0] != "export" or "inf" in found[0].lower()):
            line = text[:found.end()].rsplit("\n", 1)[-1]
            raise Fault(f"{what}: {name} has '{line}'")
    if code in (1, 2):
        errors = [line for line in done.stderr.splitlines() if line
                  and "warning:" not in line and "note:" not in line]
        if not errors:
            raise Fault(f"{what}: code {code} without a reason")
    return code, done.stdout, done.stderr, used


def refuse(word):
    raise Fault(f"JSON contains {word}")


def numbers(text, what):
    try:
        return json.loads(text, parse_constant=refuse)
    except ValueError as error:
        raise Fault(f"{what}: invalid JSON ({error}): {text[:200]}") from error


def file_at_fault(path):
    """Checks that no number is infinite and that FIELDS contain no NaN.

    Returns the names of other data with NaN (undefined quantities)."""
    undefined = set()

    def visit(name, thing):
        for key, value in thing.attrs.items():
            value = numpy.asarray(value)
            if value.dtype.kind == "f" and numpy.isinf(value).any():
                raise Fault(f"{path}: {name}@{key} is infinite")
        if not isinstance(thing, h5py.Dataset) or thing.dtype.kind != "f":
            return
        values = thing[...]
        if numpy.isinf(values).any():
            raise Fault(f"{path}: {name} is infinite")
        if numpy.isnan(values).any():
            if name in FIELDS:
                raise Fault(f"{path}: {name} contains NaN")
            undefined.add(name)

    with h5py.File(path, "r") as h5:
        visit("/", h5)
        h5.visititems(visit)
    return undefined


def clear(*paths):
    for path in paths:
        for name in (path, path + ".restart"):
            if os.path.exists(name):
                os.remove(name)


def content(path):
    return [call(["export", path])[1], call(["export", path, "--all"])[1]]


def killed(case, whole, seconds, when):
    """Kills a run after a fraction `when` of its time, resumes it, and compares
    it with the whole run."""
    part = "killed.h5"
    clear(part)
    run = subprocess.Popen([OVERROLL, "run", case, "-o", part, "-q"],
                           stdin=subprocess.DEVNULL,
                           stdout=subprocess.DEVNULL,
                           stderr=subprocess.DEVNULL)
    try:
        run.wait(timeout=max(0.02, when * seconds))
        return "not killed"
    except subprocess.TimeoutExpired:
        run.kill()
        run.wait()
    if not os.path.exists(part):
        return "killed before the file"
    code, _, err, _ = call(["resume", part, "-q"], 20 * seconds + 60,
                           (0, 1, 2, 3))
    if code == 2 and "no checkpoint" in err:
        code, _, err, _ = call(["resume", part, "-q", "--from-start",
                                "--force"], 20 * seconds + 60, (0, 1, 3))
    if code is None:
        return "resume out of time"
    if content(part) != content(whole):
        raise Fault(f"{case}: resumed run differs ({code}: {err})")
    return "resumed"


def try_case(case, number, most):
    """Returns outcome, CPU time relative to the estimate (None: not compared)
    and a remark."""
    code, out, err, _ = call(["check", case, "--json"])
    if code == 2:
        return "refused", None, err.strip()
    summary = numbers(out, "check")
    call(["check", case])
    _, out, _, _ = call(["check", case, "-v"])
    with open("again.ini", "w", encoding="utf-8") as again:
        again.write(out)
    _, out, err, _ = call(["check", "again.ini", "--json"])
    if not out:
        raise Fault(f"{case}: the output of check -v is not a case: {err}")
    again = numbers(out, "check of check -v")
    for key in ("M", "L", "nodes", "steps", "H_cen_moes", "inlet"):
        a, b = summary[key], again[key]
        if a != b and not abs(a - b) <= 1e-9 * abs(a):
            raise Fault(f"{case}: {key} of check -v is {b}, not {a}")
    estimate = summary["estimated_seconds"]
    if most and estimate > most:
        return "skipped", None, f"estimate {estimate:.3g} s"
    if (summary["memory_bytes"] or 0) > MEMORY / 2:
        return "skipped", None, f"{summary['memory_bytes']:.3g} bytes"
    result = "whole.h5"
    clear(result)
    limit = (30 * estimate + 60) * SLOWER
    style = ["--json"] if number % 2 else []
    begun = time.monotonic()
    code, out, err, used = call(["run", case, "-o", result, *style], limit,
                                (0, 1, 2, 3, 143), PATIENCE)
    seconds = time.monotonic() - begun
    cost = used / estimate
    compared = max(used, estimate) > START and not INSTRUMENTED
    if code is None:
        return "out of time", cost, f"after {used:.0f} s of CPU"
    if style and out:
        summary = numbers(out, "run")
        if code < 2 and summary["converged"] != (code == 0):
            raise Fault(f"{case}: exit code {code}, converged "
                        f"{summary['converged']}")
    if code in (0, 3) and not out:
        raise Fault(f"{case}: no report")
    remark = ""
    if code:
        remark = ([line for line in err.splitlines()
                   if line and not re.match(r" *\d+ %", line)] or [""])[-1]
    if os.path.exists(result):
        undefined = file_at_fault(result)
        if undefined and os.environ.get("OVERROLL_UNDEFINED"):
            print("    NaN:", " ".join(sorted(undefined)))
        _, out, _, _ = call(["info", result, "--json"])
        numbers(out, "info")
        call(["info", result])
        # Undefined quantities are empty or nan in tables.
        call(["export", result, "-o", "t.csv", "--force"])
        call(["export", result, "--snapshot", "last", "-o", "s.csv",
              "--force"], codes=(0, 1, 2))
        if number % 5 == 0:
            call(["view", result, "-o", "p.html", "--force", "-q"],
                 codes=(0, 1, 2))
        if code in (0, 3) and used < KILLED:
            how = killed(case, result, seconds, (0.3, 0.6, 0.9)[number % 3])
            remark += f" [{how}]"
    elif code == 0:
        raise Fault(f"{case}: no file")
    outcome = {0: "solved", 1: "failed", 2: "refused late", 3: "flagged",
               143: "stopped"}[code]
    return outcome, cost if compared and code in (0, 3) else None, remark


def main():
    folder, first, count = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    most = float(sys.argv[4]) if len(sys.argv) > 4 else 0
    os.chdir(folder)
    outcomes, costs, faults = {}, [], 0
    for number in range(first, first + count):
        begun = time.monotonic()
        try:
            outcome, cost, remark = try_case(f"{number}.ini", number, most)
        except Fault as fault:
            outcome, cost, remark = "FAULT", None, str(fault)
            faults += 1
        outcomes[outcome] = outcomes.get(outcome, 0) + 1
        if cost is not None:
            costs.append(cost)
        print(f"{number} {outcome}"
              f"{'' if cost is None else f' cost {cost:.3g}'}"
              f" {time.monotonic() - begun:.1f} s {remark}", flush=True)
    dear = sum(cost > 10 for cost in costs)
    print(outcomes, f"{dear} of {len(costs)} took ten times the estimate")
    if faults or (len(costs) >= 100 and 20 * dear > len(costs)):
        sys.exit("FAULTS" if faults else "estimates too low")


if __name__ == "__main__":
    main()
