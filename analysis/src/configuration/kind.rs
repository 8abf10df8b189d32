//! Kinds of configuration files, told by their extension.

/// Kind of a configuration file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum ConfigKind {
    /// `*.ChannelConfig`: mapping, connections, parameters, serial and CAN channels, servos, axes.
    Channel,
    /// `*.PlcErrors`: messages of the PLC program.
    Errors,
    /// `*.PlcConstants`: constants shared by program and screens.
    Constants,
    /// `*.PlcTDef`: columns of a PLC table.
    TableDefinition,
    /// `*.PlcT`: rows of a PLC table.
    Table,
    /// `*.KbdConfig`: buttons of a panel.
    Keyboard,
}

impl ConfigKind {
    /// Every kind.
    pub const ALL: [ConfigKind; 6] = [
        ConfigKind::Channel,
        ConfigKind::Errors,
        ConfigKind::Constants,
        ConfigKind::TableDefinition,
        ConfigKind::Table,
        ConfigKind::Keyboard,
    ];

    /// Its extensions without the dot; the first is the usual one.
    #[must_use]
    pub const fn extensions(self) -> &'static [&'static str] {
        match self {
            ConfigKind::Channel => &["ChannelConfig"],
            ConfigKind::Errors => &["PlcErrors"],
            // The manual prints both.
            ConfigKind::Constants => &["PlcConstants", "PlcConstans"],
            ConfigKind::TableDefinition => &["PlcTDef"],
            ConfigKind::Table => &["PlcT"],
            ConfigKind::Keyboard => &["KbdConfig"],
        }
    }

    /// The kind of the file at a path, by its extension in any case.
    #[must_use]
    pub fn of_path(path: &str) -> Option<ConfigKind> {
        let name = path.rsplit(['/', '\\']).next()?;
        let (_, extension) = name.rsplit_once('.')?;
        let is = |kind: &ConfigKind| kind.extensions().iter().any(|own| own.eq_ignore_ascii_case(extension));
        ConfigKind::ALL.into_iter().find(is)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_extension_decides_in_any_case() {
        assert_eq!(ConfigKind::of_path("a/Channel0.ChannelConfig"), Some(ConfigKind::Channel));
        assert_eq!(ConfigKind::of_path("plc0.plcerrors"), Some(ConfigKind::Errors));
        assert_eq!(ConfigKind::of_path("SAVars.PlcConstans"), Some(ConfigKind::Constants));
        assert_eq!(ConfigKind::of_path("a.PlcTDef"), Some(ConfigKind::TableDefinition));
        assert_eq!(ConfigKind::of_path("a.PlcT"), Some(ConfigKind::Table));
        assert_eq!(ConfigKind::of_path("KbdConfig"), None);
        assert_eq!(ConfigKind::of_path("a.KbdConfig/x.plc"), None);
    }
}
