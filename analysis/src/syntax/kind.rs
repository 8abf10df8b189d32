//! Kinds of tree nodes and tokens.

/// A node of the lossless tree.
pub type SyntaxNode = rowan::SyntaxNode<Technol>;
/// A token of the lossless tree.
pub type SyntaxToken = rowan::SyntaxToken<Technol>;

/// The language tag of the tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Technol {}

macro_rules! kinds {
    ($($(#[$doc:meta])* $name:ident,)*) => {
        /// Kinds of tokens and nodes.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[repr(u16)]
        pub enum SyntaxKind {
            $($(#[$doc])* $name,)*
        }

        impl SyntaxKind {
            const ALL: &'static [SyntaxKind] = &[$(SyntaxKind::$name,)*];
        }
    };
}

kinds! {
    // Tokens.
    /// Blanks and tabs.
    Whitespace,
    /// The end of a line.
    Newline,
    /// `;` and what follows.
    Comment,
    /// A name, keyword, prefix or mnemonic.
    Name,
    /// A number, good or malformed.
    Number,
    /// `'…'`.
    Text,
    /// `'…` to the end of the line.
    UnclosedText,
    /// File name after T_INCLUDE, without apostrophes.
    FileName,
    /// `,`
    Comma,
    /// `:`
    Colon,
    /// `.`
    Dot,
    /// `+`
    Plus,
    /// `-`
    Minus,
    /// `$`
    Dollar,
    /// `(`
    LeftParen,
    /// `)`
    RightParen,
    /// `[`
    LeftBracket,
    /// `]`
    RightBracket,
    /// A character without meaning.
    Unexpected,

    // Nodes: the file and its sections.
    /// The whole text.
    File,
    /// DATA … DATA_END.
    Data,
    /// DATA_LOCAL … DATA_LOCAL_END.
    DataLocal,
    /// MODULE_x … MODULE_x_END.
    Module,
    /// MECH_BEGIN … MECH_END.
    Mechanism,
    /// PROC_BEGIN … PROC_END.
    Procedure,
    /// DEF_T_MACRO … END_T_MACRO.
    Macro,

    // Nodes: a line and its parts.
    /// A line with its end.
    Line,
    /// `NAME:`.
    Label,
    /// The mnemonic or keyword.
    Operation,
    /// A lone `-`.
    SkippedOperand,
    /// `$`.
    DollarOperand,
    /// A name as operand.
    NameOperand,
    /// A number as operand.
    NumberOperand,
    /// A text or file name as operand.
    TextOperand,
    /// `-a`, `+a`.
    SignOperand,
    /// `a + b`, `a - b`.
    SumOperand,
    /// `( … )`.
    ParensOperand,
    /// `a[b]`.
    IndexOperand,
    /// `a.b`.
    DotOperand,
    /// What could not be read.
    ErrorOperand,
}

impl rowan::Language for Technol {
    type Kind = SyntaxKind;

    fn kind_from_raw(raw: rowan::SyntaxKind) -> SyntaxKind {
        SyntaxKind::ALL.get(raw.0 as usize).copied().unwrap_or(SyntaxKind::Unexpected)
    }

    fn kind_to_raw(kind: SyntaxKind) -> rowan::SyntaxKind {
        rowan::SyntaxKind(kind as u16)
    }
}
