"""Haptic devices with brakes in place of motors: the C++ library passive_haptics from Python.

A controller is made of a mechanism, its brakes, a scene and a law, and called once a cycle or for many states at once:

    arm = passive_haptics.tendon_two_link()
    wall = passive_haptics.wall(passive_haptics.half_space([0, 0.225], [0, -1]))
    control = passive_haptics.controller(
        arm, arm.brakes(), passive_haptics.scene(wall), passive_haptics.direct_control()
    )
    result = control(passive_haptics.device_state(time=0, q=[0.7, 0.8], qd=[0.1, 0], hand_force=[0, 2]))
"""

import os

from passive_haptics._native import *
from passive_haptics._native import __version__ as __version__
from passive_haptics.chains import nearest_pose as nearest_pose
from passive_haptics.chains import planar_arm as planar_arm
from passive_haptics.logs import motion_log as motion_log
from passive_haptics.logs import read_log as read_log
from passive_haptics.logs import write_log as write_log
from passive_haptics.results import contact_metrics as contact_metrics
from passive_haptics.results import contact_report as contact_report
from passive_haptics.results import display_class as display_class
from passive_haptics.results import power_class as power_class
from passive_haptics.results import run_end as run_end
from passive_haptics.results import status as status
from passive_haptics.results import wall_limits as wall_limits


def include_folders() -> list[str]:
    """The folders of the headers with which a mechanism of your own is bound: of this library, and of Eigen."""
    return [os.path.join(os.path.dirname(__file__), "include"), "/usr/include/eigen3"]
