// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

/// A formula of a few variables, in the syntax of muParser. Evaluating takes some
/// tens of nanoseconds. Not for several threads at once.
class Expression {
public:
    /// `name` is the parameter's, for error sentences; `variables` are one letter each, such as
    /// "xyz". Throws InvalidInput where the text does not parse: what is wrong, and where.
    Expression(const std::string &name, const std::string &text, const std::string &variables);
    ~Expression();
    Expression(Expression &&) noexcept;

    /// The value with the variables as given, in their order. May be NaN or infinite.
    double at(const double *values) const;
    double at(const vcg::Point3d &p) const { return at(p.V()); }

    const std::string &name() const { return name_; }

private:
    struct Parser; // muParser's header stays out of ours
    std::string name_;
    std::unique_ptr<Parser> parser_;
};

} // namespace neuralmesh
