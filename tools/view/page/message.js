// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
// Messages from the server as it packs them: see tools/view/scene/page_message.hpp for the bytes and
// tools/view/scene/scene_message.hpp for what a frame holds.

const kArrayTypes = {
  int8: Int8Array, uint8: Uint8Array, int16: Int16Array, uint16: Uint16Array,
};

/// The facts of a message, with its typed arrays, by name, as views of `buffer`.
export function decodeMessage(buffer) {
  const length = new DataView(buffer).getUint32(0, true);
  const facts = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length)));
  const arrays = {};
  for (const [name, {type, offset, count}] of Object.entries(facts.arrays ?? {})) {
    arrays[name] = new kArrayTypes[type](buffer, 4 + length + offset, count);
  }
  return {...facts, arrays};
}
