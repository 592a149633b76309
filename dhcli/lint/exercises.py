"""Rules for exercises: their own tests come out, their solutions are right, and nobody is left without help."""

from __future__ import annotations

from collections.abc import Iterator

from dhcli.algebra.floats import Floats
from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.figures import held_back
from dhcli.checking.judge import Judge
from dhcli.checking.tolerance import Tolerance
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.checking.written import Trial
from dhcli.errors import DhcliError
from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.limits import is_within_limits
from dhcli.kinematics.validity import Finding
from dhcli.kinematics.values import symbols_of
from dhcli.lint import lengths
from dhcli.lint.kept import kept
from dhcli.lint.mistakes import typed
from dhcli.lint.wording import unfinished
from dhcli.notation.quantity import value_text
from dhcli.notation.tree import Expr
from dhcli.notation.walk import symbols
from dhcli.regex import regex

_IN_BRACKETS = regex(r"\(([^()]*(?:\([^()]*\)[^()]*)*)\)")

LARGEST_ROTATION = 0.1
"""A direction cosine that may be off by more says nothing: 6° and more."""

LARGEST_SHARE = 0.1
"""A position may be off by this share of the smallest length, or a forgotten length could pass."""

LARGEST_ANGLE = 5.0

PASSED = (Verdict.RIGHT.word, Verdict.EQUIVALENT.word)


def written(exercise: Exercise) -> Iterator[Finding]:
    """Every broken rule about what stands in the file, for which nothing is judged."""
    yield from _texts(exercise)
    yield from lengths.of_exercise(exercise)
    for part in exercise.asked:
        yield from _help(part, ("parts", part.index))
    verdicts = {trial.verdict for trial in exercise.trials}
    for verdict in (Verdict.RIGHT, Verdict.WRONG):
        if verdict.word not in verdicts and exercise.asked:
            hint = f"tests: - {{part: {exercise.asked[0].id}, answer: ..., verdict: {verdict.word}}}"
            yield Finding(("tests",), f"tests: none is {verdict.word}", hint)


def findings(judge: Judge) -> Iterator[Finding]:
    """Every broken rule that judging shows, apart from those about variants and the mistakes that the pose hides."""
    exercise = judge.exercise
    yield from _blank_sheet(judge)
    yield from _within_limits(exercise)
    yield from _picture(exercise)
    for part in exercise.asked:
        yield from kept(_of_part(judge, part, ("parts", part.index)), ("parts", part.index), part.id)
    tolerances = tuple(_tolerances(exercise))
    yield from tolerances
    if not tolerances:  # else tests fail that are right
        yield from _trials(judge)


def _of_part(judge: Judge, part: Part, where: tuple[str | int, ...]) -> Iterator[Finding]:
    """What judging shows of one part."""
    yield from judge.findings(part, where)
    yield from _solution(judge, part, where)
    yield from _given_away(judge, part, where)
    yield from _printed(judge, part)


def _given_away(judge: Judge, part: Part, where: tuple[str | int, ...]) -> Iterator[Finding]:
    """A question whose words, or what stands in brackets in them, are the answer."""
    heading = part.heading(judge.exercise)
    for text in (heading.rpartition(":")[0], *_IN_BRACKETS.findall(heading)):
        if text and _judged(judge, part, text).verdict.passed:
            message = f"{part.id}: the question shows its answer: {heading}"
            yield Finding(where, message, "prompt: says in words what is asked; how it is found is not shown then")
            return


def _picture(exercise: Exercise) -> Iterator[Finding]:
    """A picture that would answer a part, or that shows nothing."""
    where: tuple[str | int, ...] = ("picture",)
    if (
        exercise.picture
        and exercise.robot is None
        and not any(part.question.linkage_counted for part in exercise.asked)
    ):
        yield Finding(where, "picture: there is neither an arm nor a linkage to draw", "leave picture: out")
    elif exercise.picture == "frames" and (parts := held_back(exercise)):
        message = f"picture: frames would answer {', '.join(part.id for part in parts)}, and are not shown"
        kinds = {part.question.words[0] for part in parts}
        yield Finding(where, message, f"picture: axes; frames may not stand beside: {', '.join(sorted(kinds))}")


def _texts(exercise: Exercise) -> Iterator[Finding]:
    texts: dict[tuple[str | int, ...], str] = {
        ("title",): exercise.title,
        ("source",): exercise.source,
        ("task",): exercise.task,
    }
    texts = {where: text for where, text in texts.items() if text}  # what is not there was told by the loader
    for part in exercise.parts:
        if part.prompt:
            texts["parts", part.index, "prompt"] = part.prompt
        texts |= {("parts", part.index, "hints", k, "hint"): hint for k, hint in enumerate(part.hints)}
    yield from unfinished(texts)


def _within_limits(exercise: Exercise) -> Iterator[Finding]:
    """A value that the joint cannot take is rarely meant."""
    robot = exercise.robot
    for name, value in exercise.given.items() if robot else ():
        if robot and not symbols_of(value) and not is_within_limits(robot, name, in_floats(value)):
            shown = " to ".join(map(value_text, robot.limits[name]))
            message = f"{name}: {value_text(value)} is outside its limits, {shown}"
            yield Finding(("given", name), message, "give it a value that the joint can take", is_warning=True)


def _blank_sheet(judge: Judge) -> Iterator[Finding]:
    """Whoever hands in nothing has solved nothing."""
    for one in judge.sheet({part.id: "_" for part in judge.exercise.parts}).parts:
        if one.mark.verdict is not Verdict.SKIPPED or one.mark.earned:
            yield Finding(("parts", one.part.index), f"{one.part.id}: a blank answer is judged {one.mark.verdict.word}")


def _help(part: Part, where: tuple[str | int, ...]) -> Iterator[Finding]:
    if not part.hints:
        yield Finding((*where, "hints"), f"{part.id}: has no hints", "hints: [gentle, plain]")
    for k, hint in enumerate(part.hints):
        if hint in part.hints[:k]:
            yield Finding((*where, "hints", k), f"{part.id}: the same hint stands twice", "the second one goes further")
    if not part.credit > 0:
        yield Finding((*where, "credit"), f"{part.id}: is worth nothing", "credit: 1")
    for k, name in enumerate(part.depends):
        if name in part.depends[:k]:
            yield Finding((*where, "depends", k), f"{part.id}: depends on {name} twice", "delete one")


def _solution(judge: Judge, part: Part, where: tuple[str | int, ...]) -> Iterator[Finding]:
    """What dhcli shows as the right answer must be judged so, when somebody types it in."""
    try:
        answer = judge.expected(part)
        judged = judge.mark(part, answer)
    except DhcliError as error:
        if not any(trial.part == part.id and trial.verdict == Verdict.RIGHT.word for trial in judge.exercise.trials):
            hint = error.problems[0].hint or "or show the right answer in a test"
            yield Finding((*where, "ask"), f"{part.id}: has no solution: {error.problems[0].message}", hint)
        return
    if judged.verdict is not Verdict.RIGHT:
        yield Finding((*where, "ask"), f"{part.id}: its own solution {answer} is judged {_told(judged)}")


def _printed(judge: Judge, part: Part) -> Iterator[Finding]:
    """What a document prints is right, or is known to be a misprint; an author's own slip is neither."""
    if part.printed is None:
        return
    judged = _judged(judge, part, part.printed.text)
    where = ("printed", part.id)
    is_misprint = any("misprint" in remark for remark in judged.remarks)
    if judged.verdict in (Verdict.CANNOT_READ, Verdict.SKIPPED) and not is_misprint:
        yield Finding(where, f"printed: {part.id}: is judged {_told(judged)}", "write it as a student would")
    elif judged.verdict.passed is False and not is_misprint:
        yield Finding(where, f"printed: {part.id}: is judged {_told(judged)}, and no misprint is recognised in it")
    elif is_misprint and not part.printed.note:
        hint = f"a misprint: {part.id}: {{answer: ..., note: what is wrong with it}}; a typo of yours: mend it"
        yield Finding(where, f"printed: {part.id}: {_wrong(judged)}", hint, is_warning=True)


def _wrong(judged: Mark) -> str:
    """What a printed answer says and what is right, for the first entry that is wrong."""
    wrong = [cell for cell in judged.cells if cell.verdict.passed is False]
    if not wrong:
        return f"is {judged.reading}" + (f", right is {judged.expected}" if judged.expected else ", which is not right")
    first, *others = wrong
    where = "" if len(judged.cells) == 1 else f"entry ({first.row + 1},{first.column + 1}) "
    more = f" (and {len(others)} more)" if others else ""
    return f"{where}is {first.typed}, right is {first.expected}{more}"


def _trials(judge: Judge) -> Iterator[Finding]:
    exercise = judge.exercise
    asked = {part.id for part in exercise.asked}
    for index, trial in enumerate(exercise.trials):
        if trial.part not in asked:
            continue  # it was withdrawn, or there is none, which is told
        try:
            answer = typed(judge, trial)
        except DhcliError as error:
            yield Finding(("tests", index, "mistake"), error.problems[0].message, error.problems[0].hint)
            continue
        judged = _judged(judge, exercise.part(trial.part), answer)
        if judged.verdict.word != trial.verdict:
            message = f"{trial.part}: is judged {_told(judged)}; the test says {trial.verdict}"
            if not answer:
                message = f"{trial.part}: the answer of the test is empty; it says {trial.verdict}"
            yield Finding(("tests", index, "mistake" if trial.mistake else "answer"), message, _right(judge, trial))


def _right(judge: Judge, trial: Trial) -> str:
    """The right answer, where a test holds another one for right."""
    try:
        answer = judge.shortest(judge.exercise.part(trial.part)) if trial.verdict in PASSED else ""
    except DhcliError:
        return ""
    return f"right is {answer}" if answer else ""


def _tolerances(exercise: Exercise) -> Iterator[Finding]:
    yield from _directions(exercise.tolerance)
    smallest = _smallest_length(exercise)
    limit = exercise.tolerance.position
    if limit is not None and smallest is not None and limit > LARGEST_SHARE * smallest[1]:
        name, value = smallest
        message = f"position: a tolerance of {limit * 1000:g} mm is large beside {name} = {value * 1000:g} mm"
        hint = f"at most {LARGEST_SHARE * value * 1000:g} mm, or an answer without {name} may pass"
        yield Finding(("tolerance", "position"), message, hint)


def _directions(tolerance: Tolerance) -> Iterator[Finding]:
    if tolerance.rotation >= LARGEST_ROTATION:
        message = f"rotation: a direction cosine may be off by {tolerance.rotation:g}"
        yield Finding(("tolerance", "rotation"), message, f"less than {LARGEST_ROTATION}; the usual is 0.001")
    if tolerance.angle > LARGEST_ANGLE:
        message = f"angle: an angle may be off by {tolerance.angle:g}°"
        yield Finding(("tolerance", "angle"), message, f"at most {LARGEST_ANGLE:g}°; the usual is 0.05°")


def _smallest_length(exercise: Exercise) -> tuple[str, float] | None:
    """The shortest length that is not 0, of the robot or given, with its name [m]."""
    own = exercise.robot.parameters if exercise.robot else {}
    lengths = {
        name: abs(Floats().value(value))
        for name, value in {**own, **exercise.given}.items()
        if isinstance(value, Expr) and not symbols(value)
    }
    return min(((name, value) for name, value in lengths.items() if value), key=lambda pair: pair[1], default=None)


def _judged(judge: Judge, part: Part, answer: str) -> Mark:
    """A judgement; what cannot be judged at all cannot be read either."""
    try:
        return judge.mark(part, answer)
    except DhcliError as error:
        return Mark(Verdict.CANNOT_READ, answer, remarks=(error.problems[0].message,))


def _told(judged: Mark) -> str:
    """A verdict with its first reason."""
    return judged.verdict.word + (f" ({judged.remarks[0]})" if judged.remarks else "")
