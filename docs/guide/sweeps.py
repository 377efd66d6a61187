"""The pieces of code of the page batch.md: how often the paper's device displays a wall exactly."""

import numpy as np

import passive_haptics as ph
from passive_haptics.sweep import sweep, sweep_error


# An experiment
def experiment(seed: int) -> float:
    """The share of random states at a wall with an exactly displayed force."""
    random = np.random.default_rng(seed)
    arm = ph.tendon_two_link(reduction_2=0.4)
    wall = ph.wall(ph.half_space([0, 0.225], [0, -1]), stiffness=1e4)
    control = ph.controller(arm, arm.brakes(), ph.scene(wall), ph.direct_control())
    q = arm.inverse([0.1, 0.226])[0] + random.uniform(-0.2, 0.2, (1000, 2))
    found = control.batch(q, random.uniform(-1, 1, (1000, 2)), random.uniform(-4, 4, (1000, 2)), fields=["display"])
    return float(np.mean(found.display == ph.display_class.exact))


def faulty(seed: int) -> float:
    """One experiment of these fails."""
    return experiment(seed) / (seed - 7)


if __name__ == "__main__":
    # On this machine
    shares = sweep(experiment, range(300), file="shares.sweep")
    print(f"{np.mean(shares):.3f} +- {np.std(shares) / len(shares) ** 0.5:.3f} of the states")

    # What fails
    try:
        sweep(faulty, range(300))
    except sweep_error as error:
        print(error)
        print(len(error.results), "others have results;", error.failures[7].splitlines()[-1])
