"""The Franka Panda with its hand, from MuJoCo Menagerie (Apache-2.0)."""

from optimus.robots.robot import Robot

PANDA = Robot(
    name="panda",
    source="menagerie:franka_emika_panda",
    joints=tuple(f"joint{i}" for i in range(1, 8)),
    fingers=("finger_joint1", "finger_joint2"),
    finger_bodies=("left_finger", "right_finger"),
    hand="hand",
    tcp=(0.0, 0.0, 0.1034),
    # tcp at (0.50, 0, 0.25) m in the base frame, pointing straight down
    home=(0.0, -0.0419, 0.0, -2.3344, 0.0, 2.2925, 0.7854),
    torque_limits=(87.0, 87.0, 87.0, 87.0, 12.0, 12.0, 12.0),
    speed_limits=(2.175, 2.175, 2.175, 2.175, 2.61, 2.61, 2.61),
    finger_open=(0.04, 0.04),
    gripper_actuator="actuator8",
    actuator_travel=(0.0, 0.04),
    # one thick box for Menagerie's five thin ones, in which a round thing can get caught
    pad_pos=(0.0, 0.004, 0.0445),
    pad_half=(0.0085, 0.004, 0.0095),
    camera_pos=(0.07, 0.0, 0.02),
    camera_target=(0.0, 0.0, 0.13),
    ik="panda",
)
