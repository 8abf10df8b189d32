//! From text to [`Document`].
//!
//! The parser never expands entities of a document type: a DTD is refused. Nested elements cost no stack. What a
//! hostile text could still cost is bounded here: its length, its elements, and the attributes of one tag, which
//! the parser compares with each other.

use roxmltree::{Error, Node, ParsingOptions};

use super::document::{Attribute, Document, Element, Lines, Text};
use super::problem::Problem;
use crate::diagnostics::rules::configuration as rules;
use crate::location::Span;

/// Longest text that is looked at, in bytes.
pub const MOST_BYTES: usize = 16 << 20;
/// Most nodes (elements, texts, comments) of a file.
pub const MOST_NODES: u32 = 1_000_000;
/// Most attributes of one tag.
const MOST_ATTRIBUTES: usize = 256;
/// Most declarations of name spaces in a file: each element carries those of all around it.
const MOST_NAMESPACES: usize = 64;

/// Reads a text.
///
/// # Errors
/// The first mistake, at its place.
pub fn parse(text: &str) -> Result<Document, Box<Problem>> {
    let lines = Lines::of(text);
    let too_large = |at: usize, message: String| {
        let first = text[at..].chars().next().map_or(0, char::len_utf8);
        Box::new(Problem::new(&rules::BROKEN_CONFIGURATION, lines.span(at..at + first), message))
    };
    if text.len() > MOST_BYTES {
        return Err(too_large(0, format!("the file is longer than {} MB; it is not read", MOST_BYTES >> 20)));
    }
    if let Some(at) = crowded_tag(text) {
        return Err(too_large(at, format!("this tag has more than {MOST_ATTRIBUTES} attributes")));
    }
    if let Some((at, _)) = text.match_indices("xmlns").nth(MOST_NAMESPACES) {
        return Err(too_large(at, format!("the file declares more than {MOST_NAMESPACES} name spaces")));
    }
    let options = ParsingOptions { allow_dtd: false, nodes_limit: MOST_NODES, entity_resolver: None };
    match roxmltree::Document::parse_with_options(text, options) {
        Ok(parsed) => Ok(plain(text, &lines, parsed.root())),
        Err(error) => Err(Box::new(problem(text, &lines, &error))),
    }
}

/// The offset of a tag with too many attributes. Counts `=` between `<` and `>` outside of quotes, which in a
/// well-formed tag is the number of its attributes.
fn crowded_tag(text: &str) -> Option<usize> {
    let mut at = 0;
    while let Some(start) = text[at..].find('<').map(|open| at + open) {
        let rest = &text[start..];
        let skipped = [("<!--", "-->"), ("<![CDATA[", "]]>"), ("<?", "?>")]
            .into_iter()
            .find(|(open, _)| rest.starts_with(open))
            .map(|(_, close)| rest.find(close).map_or(rest.len(), |end| end + close.len()));
        at = start + skipped.unwrap_or(1);
        if skipped.is_some() {
            continue;
        }
        let (mut quote, mut count) = (None, 0);
        for byte in text[at..].bytes() {
            at += 1;
            match (quote, byte) {
                (Some(open), _) if byte == open => quote = None,
                (Some(_), _) => {}
                (None, b'"' | b'\'') => quote = Some(byte),
                (None, b'>') => break,
                (None, b'=') => count += 1,
                (None, _) => {}
            }
            if count > MOST_ATTRIBUTES {
                return Some(start);
            }
        }
    }
    None
}

fn plain(text: &str, lines: &Lines<'_>, root: Node<'_, '_>) -> Document {
    let mut elements: Vec<Element> = Vec::new();
    // Index in `elements` by the parser's number.
    let mut known = std::collections::HashMap::new();
    for node in root.descendants().filter(Node::is_element) {
        let parent = node.parent().and_then(|parent| known.get(&parent.id()).copied());
        known.insert(node.id(), elements.len());
        elements.push(Element {
            name: tag_name(text, lines, node),
            parent,
            attributes: node.attributes().map(|it| attribute(lines, &it)).collect(),
            content: content(text, lines, node),
            note: note(text, node),
        });
    }
    Document { elements }
}

fn tag_name(text: &str, lines: &Lines<'_>, node: Node<'_, '_>) -> Text {
    let start = node.range().start + 1;
    let rest = text.get(start..).unwrap_or_default();
    let len = rest.find(|c: char| c.is_whitespace() || matches!(c, '/' | '>')).unwrap_or(rest.len());
    Text { text: node.tag_name().name().to_string(), span: lines.span(start..start + len) }
}

fn attribute(lines: &Lines<'_>, attribute: &roxmltree::Attribute<'_, '_>) -> Attribute {
    Attribute {
        name: Text { text: attribute.name().to_string(), span: lines.span(attribute.range_qname()) },
        value: Text { text: attribute.value().to_string(), span: lines.span(attribute.range_value()) },
    }
}

fn content(text: &str, lines: &Lines<'_>, node: Node<'_, '_>) -> Text {
    let mut joined = String::new();
    let mut range: Option<std::ops::Range<usize>> = None;
    for child in node.children().filter(Node::is_text) {
        let own = child.range();
        let Some(raw) = text.get(own.clone()) else { continue };
        let start = own.start + (raw.len() - raw.trim_start().len());
        let end = own.start + raw.trim_end().len();
        if start < end {
            joined.push_str(child.text().unwrap_or_default());
            range = Some(range.map_or(start, |range| range.start)..end);
        }
    }
    let range = range.unwrap_or_else(|| {
        // Behind the opening tag, or at the end of one that closes itself.
        let first = node.first_child().map_or(node.range().end, |child| child.range().start);
        first..first
    });
    Text { text: joined.trim().to_string(), span: lines.span(range) }
}

/// The comment behind an element, up to the end of its last line.
fn note(text: &str, node: Node<'_, '_>) -> String {
    let end = node.range().end;
    for sibling in node.next_siblings().skip(1) {
        let between = text.get(end..sibling.range().start).unwrap_or("\n");
        if between.contains('\n') || sibling.is_element() {
            break;
        }
        if sibling.is_comment() {
            return sibling.text().unwrap_or_default().trim().to_string();
        }
    }
    String::new()
}

fn problem(text: &str, lines: &Lines<'_>, error: &Error) -> Problem {
    let (at, message) = match error {
        Error::DtdDetected => {
            let at = text.find("<!DOCTYPE").unwrap_or(0);
            let message = "a document type is not read: nothing it declares is expanded; remove it";
            let span = lines.span(at..at + "<!DOCTYPE".len());
            return Problem::new(&rules::DOCUMENT_TYPE, span, message.to_string());
        }
        Error::UnclosedRootNode | Error::UnexpectedEndOfStream => (
            text.trim_end().len().saturating_sub(1),
            "the file ends before its elements are closed".to_string(),
        ),
        Error::NoRootNode => (0, "the file has no element".to_string()),
        Error::NodesLimitReached | Error::AttributesLimitReached | Error::NamespacesLimitReached => {
            (0, format!("the file has more than {MOST_NODES} elements and texts; it is not read"))
        }
        other => {
            let pos = other.pos();
            (lines.offset(pos.row, pos.col), reason(other))
        }
    };
    let end = text.get(at..).and_then(|rest| rest.chars().next()).map_or(at, |c| at + c.len_utf8());
    Problem::new(&rules::BROKEN_CONFIGURATION, non_empty(lines.span(at..end)), message)
}

/// A place at the end of a line shows the line's last character.
fn non_empty(span: Span) -> Span {
    let mut span = span;
    if span.end.line > span.start.line {
        span.end = span.start;
    }
    if span.start == span.end && span.start.column > 0 {
        span.start.column -= 1;
    }
    span
}

fn reason(error: &Error) -> String {
    match error {
        Error::UnexpectedCloseTag(expected, actual, _) => {
            format!("</{actual}> closes nothing: <{expected}> is open")
        }
        Error::UnknownEntityReference(name, _) => {
            format!("&{name}; means nothing here; only &lt; &gt; &amp; &quot; &apos; and &#number; do")
        }
        Error::MalformedEntityReference(_) => "& must be written &amp;".to_string(),
        Error::InvalidAttributeValue(_) => "< in a value must be written &lt;".to_string(),
        Error::DuplicatedAttribute(name, _) => format!("the attribute {name} stands here twice"),
        Error::NonXmlChar(c, _) => format!("the character U+{:04X} cannot stand in XML", u32::from(*c)),
        Error::InvalidChar(expected, actual, _) => {
            format!("`{}` is needed here, not `{}`", char::from(*expected), char::from(*actual))
        }
        Error::InvalidChar2(expected, actual, _) => {
            format!("{expected} is needed here, not `{}`", char::from(*actual))
        }
        Error::InvalidString(expected, _) => format!("`{expected}` is needed here"),
        Error::InvalidName(_) => "a name is needed here".to_string(),
        Error::InvalidComment(_) => "`--` cannot stand in a comment".to_string(),
        Error::UnexpectedDeclaration(_) => "the XML declaration must begin the file".to_string(),
        Error::UnknownNamespace(prefix, _) => format!("the name space {prefix} is not declared"),
        other => {
            let text = other.to_string();
            let end = text.rfind(" at ").unwrap_or(text.len());
            format!("no well-formed XML: {}", &text[..end])
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mistake(text: &str) -> String {
        let problem = parse(text).expect_err("a mistake");
        let (start, end) = (problem.span.start, problem.span.end);
        format!(
            "{} {}:{}..{}:{} {}",
            problem.rule.code, start.line, start.column, end.line, end.column, problem.message
        )
    }

    #[test]
    fn elements_attributes_contents_and_comments_keep_their_places() {
        let text = "<?xml version=\"1.0\"?>\n<Plc>\n <Input ID = 'na&amp;ž' Bit=\"2\"/> <!-- limit -->\n <P>\n  a\n  b </P>\n</Plc>\n";
        let it = parse(text).expect("well-formed");
        let input = &it.elements[1];
        assert_eq!(
            (input.name.text.as_str(), input.parent, input.note.as_str()),
            ("Input", Some(0), "limit")
        );
        assert_eq!(input.name.span, Span::in_line(2, 2, 7));
        assert_eq!(input.attributes[0].name.span, Span::in_line(2, 8, 10));
        assert_eq!(
            input.attribute("ID").map(|v| (v.text.as_str(), v.span)),
            Some(("na&ž", Span::in_line(2, 14, 23)))
        );
        assert_eq!(input.attribute("Bit").and_then(Text::integer), Some(2));
        let content = &it.elements[2].content;
        assert_eq!(content.text, "a\n  b");
        assert_eq!((content.span.start.line, content.span.end.line, content.span.end.column), (4, 5, 3));
    }

    #[test]
    fn mistakes_have_their_place_and_a_remedy() {
        for (text, expected) in [
            ("", "T0901 0:0..0:0 the file has no element"),
            ("<a>\n <b>\n</a>\n", "T0901 2:0..2:1 </a> closes nothing: <b> is open"),
            ("<a>\n <b/>\n", "T0901 1:4..1:5 the file ends before its elements are closed"),
            ("<a>\nž & b</a>", "T0901 1:3..1:4 & must be written &amp;"),
            ("<a x='1' x='2'/>", "T0901 0:9..0:10 the attribute x stands here twice"),
            (
                "<a>&lol;</a>",
                "T0901 0:3..0:4 &lol; means nothing here; only &lt; &gt; &amp; &quot; &apos; and &#number; do",
            ),
            (
                "<!DOCTYPE a [<!ENTITY b 'c'>]>\n<a>&b;</a>",
                "T0902 0:0..0:9 a document type is not read: nothing it declares is expanded; remove it",
            ),
        ] {
            assert_eq!(mistake(text), expected, "{text}");
        }
    }

    #[test]
    fn deep_wide_and_crowded_texts_end_quickly() {
        let deep = "<a>".repeat(200_000) + &"</a>".repeat(200_000);
        assert_eq!(parse(&deep).map(|it| it.elements.len()).ok(), Some(200_000));
        let open = "<a>".repeat(200_000);
        assert!(mistake(&open).contains("ends before"));
        let crowded = format!("<a {}/>", "x='' ".repeat(100_000));
        assert!(mistake(&crowded).contains("more than 256 attributes"));
        let spaces = "<a xmlns:n='u'>".repeat(1_000);
        assert!(mistake(&spaces).contains("name spaces"));
        let comment = format!("<!-- {} isn't a tag -->\n<a><![CDATA[< {0}]]></a>", "=".repeat(1_000));
        assert!(parse(&comment).is_ok());
        let value = format!("<a x='{}'/>", "y".repeat(1 << 20));
        assert!(parse(&value).is_ok());
        let huge = " ".repeat(MOST_BYTES + 1);
        assert!(mistake(&huge).contains("longer than 16 MB"));
    }
}
