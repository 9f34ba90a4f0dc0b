// SPDX-License-Identifier: GPL-3.0-or-later
#include "samplers/surfaces/expression.h"

#include <muParser.h>

#include <algorithm>

#include "neuralmesh/errors.h"

namespace neuralmesh {
namespace {

/// As muParser puts it, which mostly says where; where it does not, with the place added.
InvalidInput doesNotParse(const std::string &name, const std::string &text,
                          const mu::ParserError &error)
{
    std::string reason = error.GetMsg();
    while (!reason.empty() && reason.back() == '.')
        reason.pop_back();
    if (reason.find("position") == std::string::npos)
        reason += " at position " + std::to_string(std::min<std::size_t>(
                                        static_cast<std::size_t>(error.GetPos()), text.size()));
    return InvalidInput(name + " does not parse: " + reason + ".");
}

} // namespace

struct Expression::Parser {
    mu::Parser parser;
    std::vector<double> variables; ///< where the parser looks for them
};

Expression::Expression(const std::string &name, const std::string &text,
                       const std::string &variables)
    : name_(name), parser_(std::make_unique<Parser>())
{
    if (text.find_first_not_of(" \t\r\n") == std::string::npos)
        throw InvalidInput(name + " is empty.");
    parser_->variables.assign(variables.size(), 0);
    try {
        for (std::size_t i = 0; i < variables.size(); ++i)
            parser_->parser.DefineVar(std::string(1, variables[i]), &parser_->variables[i]);
        parser_->parser.SetExpr(text);
        parser_->parser.Eval();
    } catch (const mu::ParserError &error) {
        throw doesNotParse(name, text, error);
    }
    if (const int results = parser_->parser.GetNumResults(); results != 1)
        throw InvalidInput(name + " must be one expression, not " + std::to_string(results) +
                           " separated by commas.");
}

Expression::~Expression() = default;
Expression::Expression(Expression &&) noexcept = default;

double Expression::at(const double *values) const
{
    std::copy_n(values, parser_->variables.size(), parser_->variables.begin());
    try {
        return parser_->parser.Eval();
    } catch (const mu::ParserError &error) {
        throw doesNotParse(name_, parser_->parser.GetExpr(), error);
    }
}

} // namespace neuralmesh
