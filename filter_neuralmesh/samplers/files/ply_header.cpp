// SPDX-License-Identifier: GPL-3.0-or-later
#include "samplers/files/ply_header.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <vector>

#include "neuralmesh/sampler_errors.h"

namespace neuralmesh {
namespace {

/// A header that does not end within so many bytes never does.
constexpr std::size_t longestHeader = 65536;

using Words = std::vector<std::string>;

/// The header line by line, each as its words.
class HeaderLines {
public:
    explicit HeaderLines(Bytes file) : file_(file) {}

    Words next()
    {
        const std::size_t limit = std::min(file_.size, longestHeader);
        const unsigned char *const end =
            std::find(file_.data + position_, file_.data + limit, '\n');
        if (end == file_.data + limit)
            throw InvalidInput("its header has no line end_header: the file is truncated or no "
                               "PLY file.");
        line_.assign(file_.data + position_, end);
        position_ = static_cast<std::size_t>(end - file_.data) + 1;
        return words();
    }

    const std::string &line() const { return line_; }
    /// Behind the last line read.
    std::size_t position() const { return position_; }

private:
    Words words() const
    {
        Words words;
        bool inWord = false;
        for (const char c : line_) {
            const bool isSpace = c == ' ' || c == '\t' || c == '\r';
            if (!isSpace && !inWord)
                words.emplace_back();
            if (!isSpace)
                words.back() += c;
            inWord = !isSpace;
        }
        return words;
    }

    Bytes file_;
    std::size_t position_ = 0;
    std::string line_;
};

struct TypeSize {
    const char *name;
    std::size_t bytes;
};

constexpr TypeSize typeSizes[] = {{"char", 1},  {"uchar", 1},   {"int8", 1},   {"uint8", 1},
                                  {"short", 2}, {"ushort", 2},  {"int16", 2},  {"uint16", 2},
                                  {"int", 4},   {"uint", 4},    {"int32", 4},  {"uint32", 4},
                                  {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};

std::size_t sizeOfType(const std::string &type)
{
    for (const TypeSize &each : typeSizes)
        if (type == each.name)
            return each.bytes;
    throw InvalidInput("its header has a property of the unknown type " + quoted(type) + ".");
}

std::uint64_t parseCount(const std::string &text)
{
    std::uint64_t count = 0;
    const char *const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, count);
    if (error == std::errc::result_out_of_range)
        throw InvalidInput("its header promises " + quoted(text) +
                           " elements, more than any file holds.");
    if (!text.empty() && text[0] == '-')
        throw InvalidInput("its header has the negative count " + quoted(text) + ".");
    if (error != std::errc() || stop != end)
        throw InvalidInput("its header has " + quoted(text) + " where a count belongs.");
    return count;
}

class HeaderParser {
public:
    explicit HeaderParser(Bytes file) : lines_(file) {}

    PointLayout parse()
    {
        lines_.next(); // "ply"
        for (Words words = lines_.next(); words != Words{"end_header"}; words = lines_.next())
            parseLine(words);
        finish();
        return layout_;
    }

private:
    enum class Part { beforeVertices, vertices, afterVertices };

    void parseLine(const Words &words)
    {
        if (words.empty() || words[0] == "comment" || words[0] == "obj_info")
            return;
        if (words[0] == "format" && words.size() == 3)
            parseFormat(words);
        else if (words[0] == "element" && words.size() == 3)
            parseElement(words[1], parseCount(words[2]));
        else if (words[0] == "property" && words.size() == 3)
            parseProperty(words[1], words[2]);
        else if (words[0] == "property" && words.size() == 5 && words[1] == "list")
            parseList(words[2], words[3]);
        else
            throw InvalidInput(
                "its header has a line that PLY does not know: " + quoted(lines_.line()) + ".");
    }

    void parseFormat(const Words &words)
    {
        if (hasFormat_)
            throw InvalidInput("its header has two lines of format.");
        if (words[1] == "ascii")
            throw NeedsConversion(NeedsConversion::Format::textPly);
        if (words[1] != "binary_little_endian" && words[1] != "binary_big_endian")
            throw InvalidInput("its header has the unknown format " + quoted(words[1]) + ".");
        if (words[2] != "1.0")
            throw InvalidInput("it is of PLY version " + quoted(words[2]) + "; there is only 1.0.");
        layout_.bigEndian = words[1] == "binary_big_endian";
        hasFormat_ = true;
    }

    void parseElement(const std::string &name, std::uint64_t count)
    {
        closeElement();
        hasElement_ = true;
        count_ = count;
        recordSize_ = 0;
        hasList_ = false;
        if (name == "vertex") {
            if (part_ != Part::beforeVertices)
                throw InvalidInput("its header has two elements of vertices.");
            part_ = Part::vertices;
            layout_.count = count;
        } else if (part_ == Part::vertices) {
            part_ = Part::afterVertices;
        }
    }

    void parseProperty(const std::string &type, const std::string &name)
    {
        requireElement();
        const std::size_t size = sizeOfType(type);
        const std::size_t axis = std::string("xyz").find(name);
        if (part_ == Part::vertices && name.size() == 1 && axis < 3) {
            if (hasAxis_[axis])
                throw InvalidInput("its vertices have the property " + name + " twice.");
            hasAxis_[axis] = true;
            layout_.coordinates[axis] = {recordSize_, coordinateType(type, name), 1, 0};
        }
        recordSize_ += size;
    }

    static NumberType coordinateType(const std::string &type, const std::string &name)
    {
        if (type == "float" || type == "float32")
            return NumberType::float32;
        if (type == "double" || type == "float64")
            return NumberType::float64;
        throw InvalidInput("its coordinate " + name + " is of type " + type +
                           "; float or double is read.");
    }

    void parseList(const std::string &countType, const std::string &itemType)
    {
        requireElement();
        sizeOfType(countType);
        sizeOfType(itemType);
        if (part_ == Part::vertices)
            throw InvalidInput("its vertices have a list property: they differ in length, so none "
                               "can be found in place. Save it without that property.");
        hasList_ = true;
    }

    void requireElement() const
    {
        if (!hasElement_)
            throw InvalidInput("its header has a property before any element.");
    }

    /// Steps over an element before the vertices.
    void closeElement()
    {
        if (part_ == Part::vertices)
            layout_.recordSize = recordSize_;
        if (part_ != Part::beforeVertices || !hasElement_ || count_ == 0)
            return;
        if (hasList_)
            throw InvalidInput("an element with a list comes before its vertices, so that their "
                               "place is unknown. Save it with the vertices first.");
        const std::uint64_t most = std::numeric_limits<std::int64_t>::max();
        if (recordSize_ > 0 && count_ > (most - bytesBefore_) / recordSize_)
            throw InvalidInput("its header promises more before the vertices than any file holds.");
        bytesBefore_ += count_ * recordSize_;
    }

    void finish()
    {
        closeElement();
        if (!hasFormat_)
            throw InvalidInput("its header does not say whether it is text or binary.");
        if (part_ == Part::beforeVertices)
            throw InvalidInput("it has no vertices.");
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (!hasAxis_[axis])
                throw InvalidInput(std::string("its vertices have no property ") + "xyz"[axis] +
                                   ".");
        layout_.firstRecord = lines_.position() + bytesBefore_;
    }

    HeaderLines lines_;
    PointLayout layout_;
    Part part_ = Part::beforeVertices;
    bool hasFormat_ = false;
    bool hasAxis_[3] = {};
    std::uint64_t bytesBefore_ = 0; ///< between the header and the vertices
    // Of the current element:
    bool hasElement_ = false;
    bool hasList_ = false;
    std::uint64_t count_ = 0;
    std::size_t recordSize_ = 0;
};

} // namespace

bool isPly(Bytes file)
{
    return file.size >= 4 && std::memcmp(file.data, "ply", 3) == 0 &&
           (file.data[3] == '\n' || file.data[3] == '\r');
}

PointLayout readPlyHeader(Bytes file)
{
    return HeaderParser(file).parse();
}

} // namespace neuralmesh
