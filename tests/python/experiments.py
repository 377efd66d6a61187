"""Experiments of a seed, for the tests of sweeps; other processes import them from here."""

import hashlib
import os
import pickle
import signal

import numpy as np

import passive_haptics as ph

BAD, UNPICKLABLE, EXITS, DIES = 17, 23, 40, 255
"""Seeds of what goes wrong."""


def experiment(seed):
    """A batch of random states of the paper's device at a wall: what its brakes are commanded."""
    random = np.random.default_rng(seed)
    arm = ph.tendon_two_link()
    plane = ph.half_space([0, 0.225], [0, -1])
    control = ph.controller(arm, arm.brakes(), ph.scene(ph.wall(plane, 1e4)), ph.direct_control())
    q = [0.7, 0.8] + random.uniform(-0.3, 0.3, (50, 2))
    found = control.batch(q, random.uniform(-1, 1, (50, 2)), random.uniform(-4, 4, (50, 2)))
    return float(found.alpha.sum()), found.capacity.copy()


def shown(item):
    """An experiment of anything."""
    return repr(item)


def troubled(seed):
    """Some experiments fail in one of the ways in which one can."""
    if seed == BAD:
        raise ValueError("no such device")
    if seed == UNPICKLABLE:
        return lambda: seed
    if seed == EXITS:
        raise SystemExit(3)
    if seed == DIES:
        os.kill(os.getpid(), signal.SIGKILL)
    return experiment(seed)


def dies_once(seed):
    """The process of the experiment that dies is killed, unless it was before: the file of SWEEP_KILLED exists."""
    path = os.environ["SWEEP_KILLED"]
    if seed == DIES and not os.path.exists(path):
        open(path, "w").close()
        os.kill(os.getpid(), signal.SIGKILL)
    return experiment(seed)


def counted(seed):
    """Writes its seed to the file of SWEEP_LOG."""
    log = os.open(os.environ["SWEEP_LOG"], os.O_WRONLY | os.O_CREAT | os.O_APPEND, 0o600)
    os.write(log, f"{os.getpid()} {seed}\n".encode())
    os.close(log)
    return experiment(seed)


def stuck_from_200(seed):
    """Experiments that do not end, after 200 that do."""
    result = counted(seed)
    while seed >= 200:
        signal.pause()
    return result


def digest(results):
    """A checksum of all bytes of results."""
    return hashlib.sha256(b"".join(pickle.dumps(result, protocol=4) for result in results)).hexdigest()


def print_digest(results):
    """For another process to compare."""
    print("digest", len(results), digest(results))
