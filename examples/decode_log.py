# SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Decodes an LCM log with the generated types alone, no LCM: one line for each alarm and decision.

usage: PYTHONPATH=<prefix>/share/fallen/python python3 decode_log.py LOG
"""
import struct
import sys

import fallen


def events(path):
    """Channel and bytes of each event: sync word, number, time, lengths, channel, data."""
    with open(path, "rb") as log:
        while header := log.read(28):
            sync, _, _, channel_length, data_length = struct.unpack(">IQQII", header)
            assert sync == 0xEDA1DA01, "damaged log"
            yield log.read(channel_length).decode(), log.read(data_length)


for channel, data in events(sys.argv[1]):
    if channel == "FALL_ALARM":
        alarm = fallen.fall_alarm_t.decode(data)
        print(channel, alarm.event_id, alarm.revision, alarm.change, "%.2f %.2f %.2f" % alarm.position)
    if channel.startswith("FALLEN_PERSONS_"):
        persons = fallen.fallen_persons_t.decode(data)
        print(channel, persons.header.seq, persons.count, persons.view.width)
