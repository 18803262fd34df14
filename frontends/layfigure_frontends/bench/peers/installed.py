"""Which peers are installed. None has to be: ``pip install 'layfigure[bench]'`` brings all that are known here."""

from __future__ import annotations

import importlib
import warnings
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, version

from layfigure.figures.figure import Figure
from layfigure_frontends.bench.ik.forward import Forward
from layfigure_frontends.bench.ik.systems import System

_HERE = "layfigure_frontends.bench.peers"


@dataclass(frozen=True)
class Peer:
    """A library to be measured beside: its title, its adapter, what that imports, and the distributions it comes with.

    An adapter has ``systems(figure)`` for inverse kinematics and ``forwards(figure)`` for forward kinematics, or one
    of them.
    """

    title: str
    adapter: str
    modules: tuple[str, ...]
    distributions: tuple[str, ...]


PEERS = (
    Peer("MuJoCo", f"{_HERE}.mujoco_forward", ("mujoco",), ("mujoco",)),
    Peer("mink", f"{_HERE}.mink_solver", ("mujoco", "mink", "daqp"), ("mink", "mujoco", "daqp")),
    Peer("PlaCo", f"{_HERE}.placo_solver", ("placo",), ("placo",)),
    Peer("Robotics Toolbox", f"{_HERE}.toolbox_solver", ("roboticstoolbox",), ("roboticstoolbox-python",)),
    Peer("Pinocchio", f"{_HERE}.pinocchio_solver", ("pinocchio",), ("pin",)),
)


@dataclass(frozen=True)
class Found:
    """What was found of a peer: its programs, or none; ``told`` says in words which version, or why there is none."""

    title: str
    told: str
    systems: tuple[System, ...] = ()
    forwards: tuple[Forward, ...] = ()


def find(peer: Peer, figure: Figure) -> Found:
    """Return what is installed of a peer. One that is missing or broken is told of in words, never an error."""
    try:
        versions = ", ".join(f"{name} {version(name)}" for name in peer.distributions)
    except PackageNotFoundError as error:
        return Found(peer.title, f"not installed ({error.name} is missing; pip install 'layfigure[bench]')")
    try:
        _import_quietly(peer.modules)
        adapter = importlib.import_module(peer.adapter)
        systems = adapter.systems(figure) if hasattr(adapter, "systems") else ()
        forwards = adapter.forwards(figure) if hasattr(adapter, "forwards") else ()
    except Exception as error:  # a stranger's library can fail in any way; the others are measured all the same
        return Found(peer.title, f"does not start: {type(error).__name__}: {error}"[:200])
    return Found(peer.title, versions, tuple(systems), tuple(forwards))


def _import_quietly(modules: tuple[str, ...]) -> None:
    """Import libraries now, so that their warnings about each other do not come between the rows."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for module in modules:
            importlib.import_module(module)
