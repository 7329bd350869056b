"""A rigid tool that is turned by a device which renders torques: the hand feels what turns it."""

from typing import final

from cotouch.coupling import EnergyMessage
from cotouch.hands._grasped_tool import GraspedTool
from cotouch.haptics import ZERO, EndOptions, Quaternion, ServoReport, TurningProxyEnd, back, product


@final
class Twisted:
    """The proxy's end of the coupling of turning. A scale does not matter to it: angles and torques have none.

    Attributes:
        end: the law's.
        orientation: of the tool, in the device's frame; None: the device was never heard.
    """

    def __init__(self, tool: GraspedTool, options: EndOptions) -> None:
        """Relaxed; where a device is heard first, nothing turns the tool.

        Args:
            tool: that it turns.
            options: of the coupling, as for places at the arm.
        """
        self.orientation: Quaternion | None = None
        self.end = TurningProxyEnd(options)
        self._tool = tool
        self._frame: Quaternion | None = None  # from the device's orientation to the tool's
        self._heard = EnergyMessage()

    def before(self, report: ServoReport | None, T: float) -> None:
        """Turns the tool towards the device in the coming step.

        Args:
            report: the newest of the device; None: nothing is known.
            T: length of the step [s].
        """
        here, goal, spin = self._tool.orientation(), None, ZERO
        if report is not None and report.orientation is not None:
            if self._frame is None:
                self._frame = product(back(report.orientation), here)
            goal, spin, self._heard = product(report.orientation, self._frame), report.spin, report.twist
        self._tool.twist(self.end.twist(here, goal, spin, self._heard, T))

    def after(self) -> None:
        """Books the step."""
        self.end.book(self._tool.twisted())
        if self._frame is not None:
            self.orientation = product(self._tool.orientation(), back(self._frame))
