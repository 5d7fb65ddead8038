"""Figures: what was measured of one row, as quantity, unit and samples."""
import dataclasses
import math
import statistics


@dataclasses.dataclass
class Figure:
    row: str        # name of the row
    what: str       # of the row, in words
    threads: int
    elements: int
    quantity: str
    unit: str
    samples: list

    @property
    def median(self):
        return statistics.median(self.samples)

    @property
    def tenth(self):
        """The value that a tenth of the samples are below."""
        ranked = sorted(self.samples)
        return ranked[math.floor(0.1 * (len(ranked) - 1))]

    @property
    def least(self):
        return min(self.samples)
