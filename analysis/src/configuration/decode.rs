//! Encodings of configuration files: a byte order mark, else what the XML declaration says, else UTF-8 when the bytes
//! are that, else what the project says, else the likelier one.

use crate::project::{Decoded, Encoding};

/// Decodes a file. `declared` is what the project says about its sources.
#[must_use]
pub fn decode(bytes: &[u8], declared: Option<Encoding>) -> Decoded {
    if bytes.starts_with(b"\xEF\xBB\xBF") {
        return crate::project::decode(bytes, Some(Encoding::Utf8));
    }
    match stated(bytes) {
        None if std::str::from_utf8(bytes).is_ok() => crate::project::decode(bytes, Some(Encoding::Utf8)),
        None => crate::project::decode(bytes, declared.filter(|it| *it != Encoding::Utf8)),
        Some(name) => {
            if let Some(encoding) = encoding(&name) {
                return crate::project::decode(bytes, Some(encoding));
            }
            let decoded = crate::project::decode(bytes, None);
            let at = decoded.text.find("encoding").unwrap_or(0);
            let problem = Some((at, "this encoding is not known here; use utf-8, windows-1250 or cp852"));
            Decoded { problem: decoded.problem.or(problem), ..decoded }
        }
    }
}

fn encoding(name: &str) -> Option<Encoding> {
    match name.to_ascii_lowercase().as_str() {
        "utf-8" | "utf8" | "us-ascii" | "ascii" => Some(Encoding::Utf8),
        "windows-1250" | "cp1250" => Some(Encoding::Windows1250),
        "cp852" | "ibm852" | "cp-852" | "ibm-852" => Some(Encoding::Cp852),
        _ => None,
    }
}

/// The encoding that `<?xml … encoding="…"?>` states.
fn stated(bytes: &[u8]) -> Option<String> {
    let head = &bytes[..bytes.len().min(256)];
    let end = head.windows(2).position(|two| two == b"?>")?;
    let head = std::str::from_utf8(&head[..end]).ok()?.strip_prefix("<?xml")?;
    let rest = head[head.find("encoding")? + "encoding".len()..].trim_start().strip_prefix('=')?.trim_start();
    let quote = rest.chars().next().filter(|c| matches!(c, '"' | '\''))?;
    rest[1..].split(quote).next().map(str::to_string)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::project::encode;

    const TEXT: &str = "<?xml version=\"1.0\" encoding=\"NAME\"?>\n<Text>Tlak oleje je příliš nízký</Text>\n";

    #[test]
    fn the_declaration_is_obeyed_whatever_the_project_says() {
        for (name, encoding) in
            [("windows-1250", Encoding::Windows1250), ("CP852", Encoding::Cp852), ("utf-8", Encoding::Utf8)]
        {
            let text = TEXT.replace("NAME", name);
            let bytes = encode(&text, encoding).expect("Czech fits");
            for project in [None, Some(Encoding::Utf8), Some(Encoding::Cp852), Some(Encoding::Windows1250)] {
                let read = decode(&bytes, project);
                assert_eq!(
                    (read.text.as_str(), read.encoding, read.problem),
                    (text.as_str(), encoding, None)
                );
            }
        }
    }

    #[test]
    fn an_editors_text_is_utf8_whatever_it_declares() {
        let text = TEXT.replace("NAME", "windows-1250");
        let read = decode(format!("\u{feff}{text}").as_bytes(), None);
        assert_eq!((read.text, read.problem), (text, None));
    }

    #[test]
    fn without_a_declaration_the_bytes_and_the_project_decide() {
        let bytes = encode("<Text>chyba čidla</Text>", Encoding::Windows1250).expect("Czech fits");
        assert_eq!(decode(&bytes, None).encoding, Encoding::Windows1250);
        assert_eq!(decode(&bytes, Some(Encoding::Utf8)).encoding, Encoding::Windows1250);
        assert_eq!(decode("<Text>č</Text>".as_bytes(), Some(Encoding::Cp852)).encoding, Encoding::Utf8);
    }

    #[test]
    fn a_wrong_declaration_is_reported() {
        assert!(decode(b"<?xml version='1.0' encoding='utf-8'?><a>\xE8</a>", None).problem.is_some());
        assert!(decode(TEXT.replace("NAME", "koi8").as_bytes(), None).problem.is_some());
    }
}
