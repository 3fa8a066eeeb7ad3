#include "deck/table/name_kinds.hpp"

#include "deck/reading/row_reader.hpp"

namespace gxrod {
namespace {

std::string quote(const CheckedWord& word) { return "\"" + word.word + "\""; }

// A list, or its only word.
std::string print_words(const std::vector<CheckedWord>& words) {
    if (words.size() == 1) return quote(words.front());
    std::vector<std::string> items;
    for (const CheckedWord& word : words) items.push_back(quote(word));
    return print_list(items);
}

template <class Word>
std::optional<Word> read_one_word(const ValueSource& from) {
    const std::optional<std::string> text = read_text(from.node, from.path, from.key, from.context);
    return text ? std::optional(Word{{*text, from.node.place, from.path}}) : std::nullopt;
}

}  // namespace

std::string choice_words(const KeySpec& key) {
    return (key.choices.size() > 1 ? "one of " : "") + quoted_list(key.choices);
}

std::string choice_schema(const KeySpec& key) {
    return fmt::format(R"({{"enum": [{}]}})", quoted_list(key.choices));
}

std::optional<std::string> Kind<std::string>::read(const ValueSource& from) {
    return read_text(from.node, from.path, from.key, from.context);
}

std::optional<PointName> Kind<PointName>::read(const ValueSource& from) {
    return read_one_word<PointName>(from);
}

std::optional<TableName> Kind<TableName>::read(const ValueSource& from) {
    return read_one_word<TableName>(from);
}

std::optional<TableNames> Kind<TableNames>::read(const ValueSource& from) {
    auto names = read_names(from.node, from.path, from.key, from.context);
    return names ? std::optional(TableNames{std::move(*names)}) : std::nullopt;
}

std::string Kind<TableNames>::print(const TableNames& value) { return print_words(value.names); }

std::optional<ChosenWord> Kind<ChosenWord>::read(const ValueSource& from) {
    auto word = read_word(from.node, from.path, from.key, from.context);
    return word ? std::optional(ChosenWord{std::move(*word)}) : std::nullopt;
}

std::optional<WordList> Kind<WordList>::read(const ValueSource& from) {
    auto words = read_words(from.node, from.path, from.key, from.context);
    return words ? std::optional(WordList{std::move(*words)}) : std::nullopt;
}

std::string Kind<WordList>::print(const WordList& value) { return print_words(value.words); }

std::string Kind<WordList>::sample(const KeySpec& key) {
    return fmt::format("[\"{}\", \"{}\"]", key.choices.front(), key.choices.back());
}

std::optional<Ends> Kind<Ends>::read(const ValueSource& from) {
    auto points = read_points(from.node, from.path, from.key, from.context);
    return points ? std::optional(Ends{{(*points)[0], (*points)[1]}}) : std::nullopt;
}

std::string Kind<Ends>::print(const Ends& value) { return print_list({quote(value[0]), quote(value[1])}); }

std::optional<JointNames> Kind<JointNames>::read(const ValueSource& from) {
    const char* one = "joint, such as \"wheel\"";
    auto joints = read_points(from.node, from.path, from.key, from.context, one);
    return joints ? std::optional(JointNames{{(*joints)[0], (*joints)[1]}}) : std::nullopt;
}

std::string Kind<JointNames>::print(const JointNames& value) {
    return print_list({quote(value[0]), quote(value[1])});
}

std::optional<Partners> Kind<Partners>::read(const ValueSource& from) {
    const char* one = "rod or an obstacle, such as \"wire\"";
    auto names = read_points(from.node, from.path, from.key, from.context, one);
    return names ? std::optional(Partners{{(*names)[0], (*names)[1]}}) : std::nullopt;
}

std::string Kind<Partners>::print(const Partners& value) {
    return print_list({quote(value[0]), quote(value[1])});
}

std::string Kind<std::variant<Vec3, PointName>>::schema(const KeySpec&) {
    return fmt::format(R"({{"anyOf": [{}, {{"type": "string"}}]}})", schema_of_array(any_number_schema, 3));
}

std::optional<std::variant<Vec3, PointName>> Kind<std::variant<Vec3, PointName>>::read(
    const ValueSource& from) {
    const auto as_value = [](auto read) { return read ? std::optional<Value>(*read) : std::nullopt; };
    return from.node.text() != nullptr ? as_value(Kind<PointName>::read(from))
                                       : as_value(Kind<Vec3>::read(from));
}

std::string Kind<std::variant<Vec3, PointName>>::print(const Value& value) {
    return std::visit([]<class One>(const One& one) { return Kind<One>::print(one); }, value);
}

std::string Kind<std::vector<CheckedStation>>::schema(const KeySpec&) {
    const std::string item = fmt::format(R"({{"anyOf": [{}, {{"type": "string"}}]}})", any_number_schema);
    return schema_of_list(schema_of_array(item, 2), 2);
}

std::optional<std::vector<CheckedStation>> Kind<std::vector<CheckedStation>>::read(const ValueSource& from) {
    return RowReader(from.key, from.context).stations(from.node, from.path);
}

std::string Kind<std::vector<CheckedStation>>::print(const std::vector<CheckedStation>& value) {
    std::vector<std::string> items;
    for (const CheckedStation& one : value)
        items.push_back(print_list({Kind<double>::print(one.fraction), quote(one.section)}));
    return print_list(items);
}

std::optional<GroupName> Kind<GroupName>::read(const ValueSource& from) {
    if (const std::string* text = from.node.text()) return *text;
    if (const auto* number = std::get_if<std::int64_t>(&from.node.value)) return *number;
    from.context.faults.add(from.node.place,
                            from.path,
                            fmt::format("expected {}, found {}", words(from.key), describe_found(from.node)));
    return std::nullopt;
}

std::string Kind<GroupName>::print(const GroupName& value) {
    return std::visit([]<class One>(const One& one) { return Kind<One>::print(one); }, value);
}

std::optional<FileColumns> Kind<FileColumns>::read(const ValueSource& from) {
    const DeckNode::Array* items = from.node.array();
    if (items == nullptr || items->size() != 2) return std::nullopt;
    FileColumns columns;
    for (std::size_t i = 0; i < 2; ++i) {
        const DeckNode& item = (*items)[i];
        if (const auto* number = std::get_if<std::int64_t>(&item.value))
            columns[i] = *number;
        else if (item.text() != nullptr)
            columns[i] = *item.text();
        else
            return std::nullopt;
    }
    return columns;
}

std::string Kind<FileColumns>::print(const FileColumns& value) {
    std::vector<std::string> items;
    for (const auto& column : value)
        items.push_back(std::visit([]<class One>(const One& one) { return Kind<One>::print(one); }, column));
    return print_list(items);
}

}  // namespace gxrod
