"""Which candidates of a generation's stream a page shows when they must keep locks, pass filters, or look different."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace

from layfigure.figures.figure import Figure
from layfigure.poses.pose import Pose
from layfigure.techniques.contract import Kept
from layfigure.techniques.keeping import Keep, keep_in_turn
from layfigure_plugins.generator.conditions import APART
from layfigure_plugins.generator.filters import REASONS, failures, floor_under
from layfigure_plugins.generator.spread import far_apart
from layfigure_plugins.generator.state import PAGE_SIZE, Generation
from layfigure_plugins.generator.stream import Stream

TRIES = 45
"""How many candidates of the stream a page may try; twice as many where no locks have to be kept, which is cheap."""

_OFF = "locks"


@dataclass(frozen=True)
class Choice:
    """A page's candidates, what became of those ``tried``, and where in the stream the next page begins.

    ``left_out`` counts failures by reason; ``spare`` are candidates that keep their locks and fail a filter; ``seen``
    are the stream's poses up to here, because one that comes again is not tried again.
    """

    passed: tuple[Pose, ...] = ()
    spare: tuple[Pose, ...] = ()
    left_out: Counter[str] = field(default_factory=Counter)
    tried: int = 0
    end: int = 0
    seen: frozenset[Pose] = frozenset()


def choose(figure: Figure, generation: Generation, before: Choice, keep: Keep) -> Choice:
    """Return the choice of the page after ``before``.

    As ordered, a page goes on in the stream until it has nine or has used up its tries; spread apart, it takes nine out
    of the next :data:`TRIES` that pass.

    Raises:
        ImpossibleError: locks are to be kept and no solver is in service.
    """
    apart = generation.conditions.spread == APART
    choice = _tried(figure, generation, before, (TRIES if apart else PAGE_SIZE, keep))
    if not apart:
        return choice
    wanted = far_apart(figure, generation.base, choice.passed, PAGE_SIZE) if choice.passed else []
    return replace(choice, passed=tuple(choice.passed[number] for number in wanted))


def _tried(figure: Figure, generation: Generation, before: Choice, aim: tuple[int, Keep]) -> Choice:
    """Return the candidates from where ``before`` ended on until ``aim[0]`` have passed."""
    wanted, keep = aim
    passed: list[Pose] = []
    spare: list[Pose] = []
    left_out: Counter[str] = Counter()
    seen = set(before.seen)
    tries = TRIES if generation.conditions.locks else 2 * TRIES
    turn, last = before.end, before.end + tries
    stream = Stream.of(figure, generation)
    while turn < last and len(passed) < wanted:
        size = min(wanted - len(passed) if generation.conditions.locks else TRIES, last - turn)
        batch = list(_new(stream.poses(range(turn, turn + size)), turn, seen))
        verdicts = _verdicts(figure, generation, [pose for _, pose in batch], keep)
        turn += size
        for (number, drawn), (pose, reason) in zip(batch, verdicts, strict=True):
            seen.add(drawn)
            if not reason:
                passed.append(pose)
            else:
                left_out[reason] += 1
                spare += [pose] if reason != _OFF else []
            if len(passed) == wanted:
                turn = number + 1
                break
    tried = len(passed) + left_out.total()
    return Choice(tuple(passed), tuple(spare[:PAGE_SIZE]), left_out, tried, turn, frozenset(seen))


def _new(poses: Sequence[Pose], first: int, seen: set[Pose]) -> Iterator[tuple[int, Pose]]:
    """Yield the poses that were not seen before, with their numbers in the stream."""
    met = set(seen)
    for number, pose in enumerate(poses, start=first):
        if pose not in met:
            met.add(pose)
            yield number, pose


def _verdicts(figure: Figure, generation: Generation, poses: Sequence[Pose], keep: Keep) -> list[tuple[Pose, str]]:
    """Return each pose as its locks leave it, and why it is left out, or ""."""
    if not poses:
        return []
    conditions = generation.conditions
    kept = brought_back(poses, generation, keep) if conditions.locks else tuple(Kept(pose, met=True) for pose in poses)
    floor = floor_under(figure, generation.base, conditions.locks)
    shapes = [answer.pose for answer in kept]
    reasons = failures(figure, shapes, conditions.tests, floor) if conditions.tests else [""] * len(shapes)
    return [(answer.pose, reason if answer.met else _OFF) for answer, reason in zip(kept, reasons, strict=True)]


def brought_back(poses: Sequence[Pose], generation: Generation, keep: Keep) -> tuple[Kept, ...]:
    """Return poses that keep the generation's locks: what was picked stays as picked where the locks allow it."""
    conditions = generation.conditions
    picked = conditions.free - generation.enabled - {limb for limb, _ in generation.varied}
    return keep_in_turn(keep, poses, conditions.locks, (conditions.free - picked, conditions.free))


def told(choice: Choice) -> str:
    """Return what is to be said about a choice: honest counts, or "" where nothing was left out."""
    reasons = {_OFF: "off their locks", **REASONS}
    counts = ", ".join(f"{choice.left_out[key]} {words}" for key, words in reasons.items() if choice.left_out[key])
    shown, tried, left = len(choice.passed), choice.tried, choice.left_out.total()
    if not tried:
        return "there are no more different candidates; this is your pose"
    if not shown and not choice.spare:
        return f"none of {tried} tries keeps the locks; this is your pose"
    if not shown:
        return f"nothing passes, so the page is unfiltered: of {tried} tried {counts}"
    if shown < PAGE_SIZE and set(choice.left_out) == {_OFF}:
        return f"only {shown} of {tried} tries keep the locks"
    few = f"there {'is' if shown == 1 else 'are'} only {shown} to choose from" if shown < PAGE_SIZE else ""
    return "; ".join(filter(None, [f"{left} of {tried} tried were left out: {counts}" if left else "", few]))
