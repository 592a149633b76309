"""Arms with joints to spare: nobody can count their solutions, and one of them is as right as another."""

from __future__ import annotations

from dhcli.checking.exercise import Case
from dhcli.checking.judge import Judge
from dhcli.checking.verdicts import Verdict
from dhcli.files.yaml.exercises import read_exercise
from dhcli.files.yaml.robots import load_robot
from dhcli.kinematics.forward import forward
from tests.row_by_row import row_by_row


def asked(robot: str, ask: str) -> Judge:
    """The judge of one question in numbers."""
    text = f"""
        format: 1
        title: x
        source: x
        task: x
        robot: {robot}
        numeric: true
        parts:
          - {{id: it, ask: '{ask}'}}
        """
    return Judge(read_exercise(text, "x.yaml", "x"))


def told(judge: Judge) -> list[str]:
    """What lint finds in the question."""
    [part] = judge.exercise.parts
    return [finding.message for finding in part.question.findings(Case(part, judge.memo), ("parts", 0))]


@row_by_row(
    ("robot", "goal", "spare"),
    [
        ("panda", "position (0.4, 0.1, 0.5)", "theta3, theta5, theta6"),
        ("articulated", "pointing (0, 0, 1)", ""),
        ("puma560", "position (0.4, 0.2, 0.3)", ""),  # its wrist turns about the point, and changes nothing
        ("planar-2r", "position (0.5, 0.3, 0)", ""),
        ("scara-yim", "position (0.4, 0.2, 0.1)", ""),
    ],
)
@row_by_row("ask", ["count solutions of {}", "joints of {} all", "joints of {}"])
def test_solutions_without_number_are_neither_counted_nor_listed(ask: str, robot: str, goal: str, spare: str) -> None:
    """Lint says which joints are to spare; one solution may be asked for."""
    found = [line for line in told(asked(robot, ask.format(goal))) if "to spare" in line]
    wanted = [f"it: with {' and '.join(spare.split(', '))} to spare there are solutions without number"]
    assert found == (wanted if spare and ask != "joints of {}" else [])


def test_any_solution_of_an_arm_with_a_joint_to_spare_is_right() -> None:
    """Whatever the joint that was held stands at."""
    q = (0.3, -0.4, 0.5, -1.6, 0.2, 1.3, 0.0)
    x, y, z = forward(load_robot("panda"), list(q)).position
    judge = asked("panda", f"joints of position ({x:.9f}, {y:.9f}, {z:.9f})")
    [part] = judge.exercise.parts
    mark = judge.check(part, ", ".join(f"{value} rad" for value in q))
    assert mark.verdict is Verdict.RIGHT
    assert any("for theta3 and theta5 and theta6 as here" in step.text for step in judge.solution(part))
