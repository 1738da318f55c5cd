"""Paces requests by a server's rates (PROTOCOL.md, Rates), so that it never refuses any."""

import time

LONGEST_WAIT_S = 60  # whatever the server asks for


class Pace:
    def __init__(self, limits, now=time.monotonic, sleep=time.sleep):
        self.now, self.sleep = now, sleep
        rates = [rates for rates in (limits.session_rates, limits.address_rates) if rates and rates.requests]
        self.per_second = min((rates.requests for rates in rates), default=0)
        # An eighth is reserved, as the two clocks differ.
        self.max_level = min((max(1, rates.requests * rates.burst_ms / 1000 * 7 / 8) for rates in rates), default=1)
        self.level = self.max_level
        self.updated = now()
        self.held_until = self.updated

    def wait(self, wanted):
        """Blocks until something may be sent; returns how many of the `wanted` requests may, at least 1."""
        delay = self.held_until - self.now()
        if delay > 0:
            self.sleep(delay)
        if not self.per_second:
            return wanted
        self._fill()
        if self.level < 1:
            self.sleep((1 - self.level) / self.per_second)
            self._fill()
            self.level = max(self.level, 1)
        granted = min(wanted, int(self.level))
        self.level -= granted
        return granted

    def refused(self, retry_after_ms):
        """The server refused a request nevertheless: everything waits."""
        self.held_until = max(self.held_until, self.now() + min(retry_after_ms / 1000, LONGEST_WAIT_S))
        self.level = 1
        self.updated = self.held_until

    def _fill(self):
        now = self.now()
        self.level = min(self.max_level, self.level + max(0, now - self.updated) * self.per_second)
        self.updated = max(self.updated, now)
