// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

namespace fallen {

/// A local vector for code that runs frame after frame: empty, but in memory that another one left
/// behind. The thread keeps the memory of all that were alive at once, so that nothing is allocated
/// once each has been as large as it gets.
template <class T>
class KeptVector : public std::vector<T> {
 public:
  KeptVector() {
    std::vector<std::vector<T>>& kept = Kept();
    if (kept.empty()) return;
    this->swap(kept.back());
    kept.pop_back();
  }
  ~KeptVector() {
    this->clear();
    Kept().push_back(std::move(*this));
  }
  KeptVector(const KeptVector&) = delete;
  KeptVector& operator=(const KeptVector&) = delete;

 private:
  static std::vector<std::vector<T>>& Kept() {
    thread_local std::vector<std::vector<T>> kept;
    return kept;
  }
};

}  // namespace fallen
