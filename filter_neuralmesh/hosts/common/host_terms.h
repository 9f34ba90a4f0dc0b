// SPDX-License-Identifier: GPL-3.0-or-later
// What a host's users call things. Sentences are the same in all hosts but for these words.
#pragma once

#include <functional>
#include <string>

#include "neuralmesh/errors.h"

namespace neuralmesh {

struct HostTerms {
    /// Names of the parameters that can be refused, such as "TargetVertNum".
    ParameterNames parameter;
    /// Of the parameter by which quality becomes density.
    std::string densityFromQuality;
    /// What stands before the path of a point file.
    std::string pointFile;
    /// Of the mesh to start from, without an article: "starting layer".
    std::string startingMesh;
    /// One end of a coordinate's or a parameter's range ('x', 'u'), such as "minX".
    std::function<std::string(char variable, bool isUpper)> rangeEnd;
    /// Values of parameters as their users give them, such as "Topology 'Learned from the data'".
    std::string learnedTopology, openBoundaries;
    /// What the host makes of numbers: the most that is finite, and how close two may be. Each
    /// starts with a comma or a semicolon, or is empty.
    std::string aboutLargest, aboutDigits;
    /// How a file that cannot be read in place is converted; each starts with a colon or a dot.
    std::string convertTextPly, convertE57;
};

} // namespace neuralmesh
