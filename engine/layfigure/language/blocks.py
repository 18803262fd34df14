"""Nests a flat run of statements: IF with its branches, loops with their bodies, models, motions and scenes.

Every block that is not closed, or closed by another's word, is told with the line where it was opened.
"""

from __future__ import annotations

from collections.abc import Callable, Container
from typing import Any

from layfigure.language import syntax as s
from layfigure.language.limits import MAXIMUM_NESTING
from layfigure.language.marks import (
    Counted,
    Head,
    If,
    Item,
    Mark,
    ModelHead,
    MotionHead,
    SceneHead,
    SceneStart,
    Separator,
    WhileHead,
    Word,
)
from layfigure.language.places import Place

_IN_SCENES = (s.View, s.Floor, s.Background)


def nested(items: tuple[Item, ...], end: Place) -> s.Block:
    """Return the statements of a script; ``end`` is the place behind the last.

    Raises:
        SourceError: a block is not closed, is closed by the wrong word, or holds what may not stand in it.
    """
    return _Nesting(items, end).script()


class _Opened:
    """A block being read: what it is called, where it began, and what may close it."""

    def __init__(self, spelled: str, place: Place, closers: Container[Word], closing: str, label: str = "") -> None:
        self.spelled = spelled
        self.place = place
        self.closers = closers
        self.closing = closing  # as a message asks for it
        self.label = label


class _Nesting:
    """A descent over the items; how deep it goes is bounded."""

    def __init__(self, items: tuple[Item, ...], end: Place) -> None:
        self._items = items
        self._end = end
        self._at = 0
        self._open: list[_Opened] = []
        self._scene = ""  # "", "initial" or "body"

    def script(self) -> s.Block:
        """Return everything, up to END where there is one."""
        block = self._block()
        mark = self._peek()
        if isinstance(mark, Mark) and mark.word is Word.END:
            self._at += 1
            self._skip_separators()
            if (rest := self._peek()) is not None:
                raise _place(rest).error("nothing may follow END, which ends the script")
        elif isinstance(mark, Mark):
            raise mark.place.error(f"found {mark.word.value}, but {_opener(mark.word)} is not open; remove it")
        elif isinstance(mark, SceneStart):
            raise mark.place.error("STARTSCENE stands in a scene; put INITIALIZE SCENE and a number before it")
        elif isinstance(mark, If):
            raise mark.place.error(f"found ELSE IF, but {_opener(Word.ELSE)} is not open; remove it")
        return block

    # -- walking -----------------------------------------------------------------------------------------------------

    def _peek(self) -> Item | None:
        return self._items[self._at] if self._at < len(self._items) else None

    def _take(self) -> Item:
        self._at += 1
        return self._items[self._at - 1]

    def _skip_separators(self) -> None:
        while isinstance(self._peek(), Separator):
            self._at += 1

    def _block(self) -> s.Block:
        """Return statements up to a mark that closes or parts the innermost open block, which stays."""
        found: list[s.Statement] = []
        while True:
            self._skip_separators()
            item = self._peek()
            if item is None or (isinstance(item, Mark | SceneStart) and not self._passes(item)):
                return tuple(found)
            if isinstance(item, If) and item.further:
                return tuple(found)
            if isinstance(item, Mark):
                self._at += 1  # a CONTINUE that closes nothing
                continue
            found.append(self._statement())
            self._separated()

    def _passes(self, item: Mark | SceneStart) -> bool:
        """Whether a mark is a CONTINUE that closes no open loop, which does nothing."""
        if not isinstance(item, Mark) or item.word is not Word.CONTINUE:
            return False
        return not any(_closes(opened, item) for opened in self._open)

    def _separated(self) -> None:
        item = self._peek()
        if item is None or isinstance(item, Separator | Mark | SceneStart) or (isinstance(item, If) and item.further):
            return
        raise _place(item).error('a statement begins before the last one ended; put ";" or a new line between them')

    def _statement(self) -> s.Statement:
        item = self._take()
        known = _BLOCKS.get(type(item))
        if known is not None:
            return known(self, item)
        assert isinstance(item, s.Statement)
        return self._allowed(item)

    def _allowed(self, item: s.Statement) -> s.Statement:
        """Return a plain statement that may stand here."""
        if isinstance(item, s.ModelJoint):
            message = 'a JOINT with links stands between STARTMODEL and ENDMODEL, or behind "name :-"'
            raise item.place.error(message)
        if isinstance(item, s.MotionJoint | s.MotionKey):
            raise item.place.error("keys of a joint stand between STARTMOTION and ENDMOTION")
        if isinstance(item, s.Animate) and self._scene != "body":
            raise item.place.error("ANIMATE stands in the body of a scene, between STARTSCENE and ENDSCENE")
        if isinstance(item, _IN_SCENES) and not self._scene:
            raise item.place.error("this stands in a scene, between INITIALIZE SCENE and ENDSCENE")
        if isinstance(item, s.Shoot) and self._scene:
            raise item.place.error("SHOOTSCENES stands behind the scenes; close this one with ENDSCENE first")
        return item

    # -- open blocks -------------------------------------------------------------------------------------------------

    def _begin(self, spelled: str, head: Head | Mark, closers: Container[Word], closing: str, label: str = "") -> None:
        if len(self._open) >= MAXIMUM_NESTING:
            raise head.place.error(f"blocks are nested deeper than {MAXIMUM_NESTING}; make the script flatter")
        self._open.append(_Opened(spelled, head.place, closers, closing, label))

    def _closed(self) -> Mark:
        """Take the mark that closes the innermost block.

        Raises:
            SourceError: another mark stands there, or the script ends.
        """
        opened = self._open[-1]
        item = self._peek()
        where = f"the {opened.spelled} of line {opened.place.line}"
        if item is None:
            raise self._end.error(f"the script ends while {where} is open; add {opened.closing}")
        if isinstance(item, Mark) and _closes(opened, item):
            self._open.pop()
            return self._close(opened, item)
        name = item.word.value if isinstance(item, Mark) else "ELSE IF" if isinstance(item, If) else "STARTSCENE"
        raise _place(item).error(f"found {name} while {where} is open; close it with {opened.closing} first")

    def _close(self, opened: _Opened, mark: Mark) -> Mark:
        shared = opened.label and any(other.label == opened.label for other in self._open)
        if not shared:  # one `10 CONTINUE` closes every DO 10 that is open
            self._at += 1
        return mark

    def _counted(self, head: Counted) -> s.Count:
        body = self._loop(head, head.spelled, *_counted_closing(head))
        return s.Count(head.place, head.variable, head.first, head.last, head.step, body)

    def _while(self, head: WhileHead) -> s.While:
        return s.While(head.place, head.condition, self._loop(head, "WHILE", (Word.ENDWHILE,), "ENDWHILE"))

    def _loop(self, head: Head, spelled: str, closers: tuple[Word, ...], closing: str) -> s.Block:
        label = head.label if isinstance(head, Counted) else ""
        self._begin(spelled, head, closers, closing, label)
        body = self._block()
        self._closed()
        return body

    # -- IF ----------------------------------------------------------------------------------------------------------

    def _choice(self, head: If) -> s.Choice:
        branches: list[tuple[s.Expression, s.Block]] = []
        otherwise: s.Block = ()
        form, block = self._branch(head)
        branches.append((head.condition, block))
        while (item := self._next_branch(form)) is not None:
            self._at += 1
            if isinstance(item, If):
                form, block = self._branch(item)
                branches.append((item.condition, block))
            else:
                form, otherwise = self._branch(item)
                break
        if form == "lines":
            self._begin("IF", head, (Word.ENDIF,), "ENDIF")
            self._closed()
        return s.Choice(head.place, tuple(branches), otherwise)

    def _branch(self, head: If | Mark) -> tuple[str, s.Block]:
        """Return how a branch is written (``begin``, ``line`` or ``lines``) and its statements."""
        on_same_line = not isinstance(self._peek(), Separator | None)
        at = self._at
        self._skip_separators()
        item = self._peek()
        if isinstance(item, Mark) and item.word is Word.BEGIN:
            self._at += 1
            self._begin("BEGIN", item, (Word.END,), "END")
            block = self._block()
            self._closed()
            return "begin", block
        if on_same_line:
            if isinstance(item, Mark | Separator | None):
                return "line", ()
            self._begin("IF of one line", head, (), "")
            statement = self._statement()
            self._open.pop()
            return "line", (statement,)
        self._at = at
        self._begin("IF", head, (Word.ELSE, Word.ENDIF), "ENDIF")
        block = self._block()
        self._open.pop()
        return "lines", block

    def _next_branch(self, form: str) -> If | Mark | None:
        """Return the ELSE or ELSE IF that goes on with this IF, and go to it; None where there is none."""
        at = self._at
        self._skip_separators()
        item = self._peek()
        further = isinstance(item, If) and item.further
        if further or (isinstance(item, Mark) and item.word is Word.ELSE):
            apart = at != self._at
            above = self._open[-1] if self._open else None
            if not (form == "line" and apart and above is not None and above.spelled == "IF"):
                assert isinstance(item, If | Mark)
                return item
        self._at = at
        return None

    # -- models, motions, scenes -------------------------------------------------------------------------------------

    def _inside(self, head: Head, spelled: str, closing: Word) -> list[s.Statement]:
        """Return the plain statements of a block in which nothing else may stand."""
        self._begin(spelled, head, (closing,), closing.value)
        found: list[s.Statement] = []
        while True:
            self._skip_separators()
            item = self._peek()
            if isinstance(item, Mark) and item.word is Word.ENDJOINT and closing is Word.ENDMOTION:
                self._at += 1
            elif isinstance(item, s.ModelJoint | s.MotionJoint | s.MotionKey):
                found.append(item)
                self._at += 1
            elif item is None or isinstance(item, Mark):
                self._closed()
                return found
            else:
                allowed = "JOINT" if closing is Word.ENDMODEL else "JOINT, FRAME and ENDJOINT"
                message = f"between {spelled} (line {head.place.line}) and {closing.value} stand only {allowed}"
                raise _place(item).error(message)

    def _model(self, head: ModelHead) -> s.ModelBlock:
        joints: list[s.JointOf] = []
        for item in self._inside(head, "STARTMODEL", Word.ENDMODEL):
            if not isinstance(item, s.ModelJoint):
                raise item.place.error(
                    "a joint of a model is: JOINT id, link, point, link, point and up to three ranges"
                )
            joints.append(item.joint)
        return s.ModelBlock(head.place, head.name, tuple(joints))

    def _motion(self, head: MotionHead) -> s.MotionBlock:
        tracks: list[tuple[s.MotionJoint, list[s.MotionKey]]] = []
        for item in self._inside(head, "STARTMOTION", Word.ENDMOTION):
            if isinstance(item, s.MotionJoint):
                tracks.append((item, []))
            elif isinstance(item, s.MotionKey) and tracks:
                tracks[-1][1].append(item)
            elif isinstance(item, s.MotionKey):
                raise item.place.error("this FRAME belongs to no joint; put JOINT and its identifier before it")
            else:
                raise item.place.error("a joint of a motion is: JOINT id [POSITION x, y, z], without links")
        return s.MotionBlock(head.place, head.name, tuple((joint, tuple(keys)) for joint, keys in tracks))

    def _scene_block(self, head: SceneHead) -> s.SceneBlock:
        if self._scene:
            raise head.place.error("a scene stands in no other scene; close the one before with ENDSCENE")
        self._begin("INITIALIZE SCENE", head, (), "STARTSCENE LENGTH ... ENDSCENE")
        self._scene = "initial"
        initial = self._block()
        start = self._peek()
        if not isinstance(start, SceneStart):
            self._closed()
        assert isinstance(start, SceneStart)
        self._at += 1
        self._open.pop()
        self._begin("STARTSCENE", start, (Word.ENDSCENE,), "ENDSCENE")
        self._scene = "body"
        body = self._block()
        self._closed()
        self._scene = ""
        return s.SceneBlock(head.place, head.number, initial, start.length, start.same_frame, body)


_BLOCKS: dict[type, Callable[[_Nesting, Any], s.Statement]] = {
    If: _Nesting._choice,
    Counted: _Nesting._counted,
    WhileHead: _Nesting._while,
    ModelHead: _Nesting._model,
    MotionHead: _Nesting._motion,
    SceneHead: _Nesting._scene_block,
}


def _counted_closing(head: Counted) -> tuple[tuple[Word, ...], str]:
    if not head.labelled:
        return (Word.ENDFOR,), "ENDFOR"
    if head.label:
        return (Word.CONTINUE,), f"{head.label} CONTINUE"
    return (Word.ENDFOR, Word.CONTINUE), "ENDDO"


def _closes(opened: _Opened, mark: Mark) -> bool:
    return mark.word in opened.closers and (mark.word is not Word.CONTINUE or mark.label == opened.label)


def _opener(word: Word) -> str:
    return {
        Word.ELSE: "an IF that it could belong to",
        Word.ENDIF: "an IF",
        Word.BEGIN: "an IF or ELSE before it",
        Word.ENDFOR: "a FOR or DO",
        Word.ENDWHILE: "a WHILE",
        Word.ENDMODEL: "a STARTMODEL",
        Word.ENDJOINT: "a STARTMOTION",
        Word.ENDMOTION: "a STARTMOTION",
        Word.ENDSCENE: "a STARTSCENE",
    }[word]


def _place(item: Item) -> Place:
    assert not isinstance(item, Separator)
    return item.place
