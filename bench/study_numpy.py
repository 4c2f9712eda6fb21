#!/usr/bin/env python3
"""The study's first-order learning experiment (S5) in vectorised NumPy, against exk-study, in one run.

Both run the same rectangle, noise and law: three runs of a series on one frozen random walk, the
forward kinematics of model P and the path error at every sample, u + K e between the runs. NumPy
takes whole batches of trials at once; exk-study goes step by step through the controller's own
loop, twin and judge, on one core. Processor time, so that a busy machine does not decide.

    bench/study_numpy.py build/release/bin/exk-study [ROUNDS]
"""
import os
import resource
import subprocess
import sys
import time

os.environ["OMP_NUM_THREADS"] = "1"
import numpy as np

DT, FEED, DWELL, K, SIGMA = 0.01, 0.1, 2.0, 0.5, 9.19e-5
Z0, D2_LESS_D4 = 0.95, 0.45
R, L2 = Z0, np.hypot(Z0, D2_LESS_D4)
CORNERS = np.array([[-0.15, -0.1], [0.15, -0.1], [0.15, 0.1], [-0.15, 0.1]])
RUNS, BATCH, TRIALS = 3, 50, 1000


def reference():
    """Tip at every tick: dwell at each corner, straight moves between, back to the first."""
    parts = []
    for i, corner in enumerate(CORNERS):
        parts.append(np.repeat(corner[None, :], round(DWELL / DT), axis=0))
        following = CORNERS[(i + 1) % 4]
        n = round(np.hypot(*(following - corner)) / FEED / DT)
        parts.append(corner + np.linspace(0, 1, n + 1)[1:, None] * (following - corner))
    return np.concatenate(parts)


def series(rng, tip, r):
    """Last-point error [m] of run 3 and rms path error for a batch of trials."""
    n = np.zeros((2, BATCH, len(tip)))
    n[:, :, 1:] = np.cumsum(rng.standard_normal((2, BATCH, len(tip) - 1)), axis=2)
    n *= SIGMA * np.sqrt(DT)
    u = np.zeros_like(n)
    for _ in range(RUNS):
        theta = r + u + n
        x, y = L2 * np.sin(theta[0]), R * np.sin(theta[1])
        z = R * np.cos(theta[1])
        radial2 = (x - tip[:, 0]) ** 2 + (y - tip[:, 1]) ** 2
        rms = np.sqrt(radial2.mean(axis=1))
        u += K * (r - theta)
    return np.sqrt(radial2[:, -1]), rms, z


def numpy_ns():
    tip = reference()
    r = np.array([np.arcsin(tip[:, 0] / L2), np.arcsin(tip[:, 1] / R)])[:, None, :]
    rng = np.random.Generator(np.random.Philox(1))
    begin = time.process_time()
    last = np.concatenate([series(rng, tip, r)[0] for _ in range(TRIALS // BATCH)])
    took = time.process_time() - begin
    return 1e9 * took / (TRIALS * RUNS * len(tip)), 1e3 * last.mean(), len(tip)


def children_s():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def exk_seconds(program, seeds):
    begin = children_s()
    subprocess.run([program, "paper", "--only", "S5", "--seeds", str(seeds), "-j", "1"],
                   check=True, stdout=subprocess.DEVNULL)
    return children_s() - begin


def main():
    program = sys.argv[1] if len(sys.argv) > 1 else "build/release/bin/exk-study"
    rounds = int(sys.argv[2]) if len(sys.argv) > 2 else 5
    ratios = []
    print("%-6s %14s %14s %8s" % ("round", "NumPy ns/step", "exk ns/step", "ratio"))
    for i in range(rounds):
        ours_few = exk_seconds(program, 10)
        ours = exk_seconds(program, 10 + TRIALS)
        theirs, mean_mm, n = numpy_ns()
        ours = 1e9 * (ours - ours_few) / (TRIALS * RUNS * n)
        ratios.append(theirs / ours)
        print("%-6d %14.1f %14.1f %8.2f" % (i + 1, theirs, ours, ratios[-1]))
    print("median ratio %.2f over %d rounds; NumPy %s, %d ticks, mean last point %.4f mm (study 0.123)"
          % (np.median(ratios), rounds, np.__version__, n, mean_mm))


if __name__ == "__main__":
    main()
