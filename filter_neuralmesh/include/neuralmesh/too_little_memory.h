// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "neuralmesh/errors.h"

namespace neuralmesh {

/// The vertices that are asked for take more memory than this machine has left. Found before any is
/// taken.
class TooLittleMemory : public InvalidInput {
public:
    TooLittleMemory(std::uint64_t vertices, std::uint64_t bytesNeeded, std::uint64_t bytesFree);

    std::uint64_t bytesNeeded() const { return bytesNeeded_; }
    std::uint64_t bytesFree() const { return bytesFree_; }

    /// The sentence of what(), with the host's name of GrowthParameters::targetVertexCount.
    std::string sentence(const ParameterNames &names) const;

private:
    std::uint64_t bytesNeeded_, bytesFree_;
};

} // namespace neuralmesh
