"""The `[channel]` table: what the network does to messages."""

from typing import Annotated, Literal, Self, final

from pydantic import Field, model_validator

from cotouch.peer import MOST_HOLD, Codec
from cotouch.scenario._tables import NonNegative, Positive, Probability, Table
from cotouch.scenario._traces import TraceTable


@final
class Jitter(Table):
    """Random delay added to every message, never negative.

    Uniform in [0, scale], exponential with mean scale, or the size of a normal with standard deviation scale [s].
    """

    kind: Literal["uniform", "exponential", "normal"] = "uniform"
    scale: NonNegative


@final
class Burst(Table):
    """Losses in bursts (Gilbert-Elliott): a good and a bad state with their own losses, switching at every message."""

    enter: Probability
    leave: Annotated[float, Field(gt=0.0, le=1.0)]
    loss_good: Probability = 0.0
    loss_bad: Probability = 1.0


@final
class CodecTable(Table):
    """The senders' perceptual codec, which says in one byte what goes on as people expect it to; see docs/codec.md.

    Attributes:
        deadband: share of a value, or of a sum's growth, that is not worth saying; people notice 7 to 10 % of a force.
        quantum: fields are rounded to multiples of this; 0: they are not [SI units].
        hold: a sample is said in full at least every so many steps.
        age: where a law needs damping for the age of samples, the damping that pays for the codec's errors is that of
            samples so much older [s].
    """

    deadband: Annotated[float, Field(ge=0.0, lt=1.0, allow_inf_nan=False)] = 0.1
    quantum: NonNegative = 0.0
    hold: Annotated[int, Field(ge=1, le=MOST_HOLD)] = 20
    age: Positive = 1e-3

    @property
    def codec(self) -> Codec:
        """For the ends of links."""
        return Codec(deadband=self.deadband, quantum=self.quantum, hold=self.hold, age=self.age)


@final
class Channel(Table):
    """What the network does to messages, besides the delay of `[network]`; the same law on every link, own draws.

    Attributes:
        jitter: random delay.
        trace: measured delay instead of random.
        loss: probability that a message is lost.
        burst: losses in bursts, on top.
        duplication: probability that a message arrives a second time, with its own delay.
        reordering: probability that a message is held back by `reordering_delay`.
        reordering_delay: [s].
        resend: after how long a lost message is sent again where every sample is needed (constant, self-paced); by
            default the link's round trip with its jitter [s].
        codec: how senders save bytes; None: every sample is sent in full.
    """

    jitter: Jitter | None = None
    trace: TraceTable | None = None
    loss: Annotated[float, Field(ge=0.0, lt=1.0)] = 0.0
    burst: Burst | None = None
    duplication: Probability = 0.0
    reordering: Probability = 0.0
    reordering_delay: NonNegative = 0.0
    resend: Positive | None = None
    codec: CodecTable | None = None

    @model_validator(mode="after")
    def _one_source(self) -> Self:
        if self.jitter is not None and self.trace is not None:
            raise ValueError("jitter and trace are given; a trace has its own jitter, so give only one of them")
        return self

    @model_validator(mode="after")
    def _late(self) -> Self:
        if self.reordering > 0.0 and self.reordering_delay == 0.0:
            raise ValueError(
                f"reordering is {self.reordering:g}, but reordering_delay is 0 s, so nothing is held back; give it more"
            )
        return self
