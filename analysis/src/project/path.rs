//! Project paths: relative to the root, with `/`.

/// `\` becomes `/`.
pub(super) fn slashes(path: &str) -> String {
    path.replace('\\', "/")
}

/// `/…` or `C:…`.
pub(super) fn is_absolute(path: &str) -> bool {
    path.starts_with('/')
        || (path.len() >= 2 && path.as_bytes()[0].is_ascii_alphabetic() && path.as_bytes()[1] == b':')
}

/// Without `.`, `..` and doubled slashes. `..` that leads above a relative path stays.
pub(super) fn normal(path: &str) -> String {
    let rooted = path.starts_with('/');
    let mut parts: Vec<&str> = Vec::new();
    for part in path.split('/') {
        match part {
            "" | "." => {}
            ".." if parts.last().is_some_and(|last| *last != "..") => {
                parts.pop();
            }
            ".." if rooted => {}
            other => parts.push(other),
        }
    }
    let joined = parts.join("/");
    if rooted { format!("/{joined}") } else { joined }
}

/// `base/path`, or `path` when it is absolute.
pub(super) fn join(base: &str, path: &str) -> String {
    if is_absolute(path) || base.is_empty() { path.to_string() } else { format!("{base}/{path}") }
}

/// Whether a path ends with `.extension`, in any case.
pub(super) fn has_extension(path: &str, extension: &str) -> bool {
    path.rsplit_once('.').is_some_and(|(_, own)| own.eq_ignore_ascii_case(extension))
}

/// The folder of a path; empty when it has none.
pub(super) fn folder(path: &str) -> &str {
    path.rfind('/').map_or("", |at| if at == 0 { "/" } else { &path[..at] })
}

/// The project path of a path relative to the root or absolute: relative when it lies under the root or when the
/// root is relative itself, else absolute.
pub(super) fn project_path(root: &str, path: &str) -> String {
    let whole = normal(&join(root, path));
    let root = normal(root);
    let mut up = root.split('/').filter(|part| !part.is_empty()).peekable();
    let mut rest = whole.split('/').filter(|part| !part.is_empty()).peekable();
    if is_absolute(&root) != is_absolute(&whole) {
        return whole;
    }
    while up.peek().is_some() && up.peek() == rest.peek() {
        up.next();
        rest.next();
    }
    let above = up.count();
    if above > 0 && is_absolute(&whole) {
        return whole;
    }
    let parts: Vec<&str> = std::iter::repeat_n("..", above).chain(rest).collect();
    parts.join("/")
}

/// A path without `.` and `..`, to compare paths that begin at the same place.
pub(super) fn whole(root: &str, path: &str) -> String {
    normal(&join(root, path))
}

/// The path a reader gets for a project path.
pub(super) fn readable(root: &str, project_path: &str) -> String {
    join(root, project_path)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_under_the_root_become_relative() {
        assert_eq!(project_path("/plc/lathe", "sub/../main.plc"), "main.plc");
        assert_eq!(project_path("/plc/lathe", "../lib/x.inc"), "/plc/lib/x.inc");
        assert_eq!(project_path("/plc/lathe", "/plc/lathe/a.plc"), "a.plc");
        assert_eq!(project_path("/plc/lathe", "/plc/lathes/a.plc"), "/plc/lathes/a.plc");
        assert_eq!(project_path("lathe", "main.plc"), "main.plc");
        assert_eq!(project_path("", "./main.plc"), "main.plc");
        assert_eq!(project_path("", "../main.plc"), "../main.plc");
        assert_eq!(project_path("lathe", "../x.plc"), "../x.plc");
        assert_eq!(project_path("a/b", "../c/x.plc"), "../c/x.plc");
        assert_eq!(project_path("/", "x.plc"), "x.plc");
    }

    #[test]
    fn folders_and_drives() {
        assert_eq!(folder("a/b.plc"), "a");
        assert_eq!(folder("b.plc"), "");
        assert_eq!(folder("/b.plc"), "/");
        assert!(is_absolute("C:/x") && is_absolute("/x") && !is_absolute("x/y"));
        assert_eq!(slashes("VXR50\\VXR50.INC"), "VXR50/VXR50.INC");
    }
}
