//! Project paths: relative to the root, with `/`.

/// `\` becomes `/`.
pub(super) fn slashes(path: &str) -> String {
    path.replace('\\', "/")
}

/// `/…` or `C:…`.
pub(super) fn is_absolute(path: &str) -> bool {
    path.starts_with('/') || (path.len() >= 2 && path.as_bytes()[0].is_ascii_alphabetic() && path.as_bytes()[1] == b':')
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

/// The folder of a path; empty when it has none.
pub(super) fn folder(path: &str) -> &str {
    path.rfind('/').map_or("", |at| if at == 0 { "/" } else { &path[..at] })
}

/// The project path of a path relative to the root or absolute: relative when it lies under the root.
pub(super) fn project_path(root: &str, path: &str) -> String {
    let whole = normal(&join(root, path));
    let root = normal(root);
    if root.is_empty() {
        return whole;
    }
    let inside = whole.strip_prefix(root.as_str());
    match inside.and_then(|rest| if root == "/" { Some(rest) } else { rest.strip_prefix('/') }) {
        Some(rest) => rest.to_string(),
        None => whole,
    }
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
