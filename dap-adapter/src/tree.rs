//! The tree of variables: what each scope holds and what expands into what. Knows addresses, not values.

use std::collections::{HashMap, HashSet};

use technol_image::debug_info::{DebugInfo, Scope, Symbol, SymbolKind};
use technol_image::op::{Addr, Width};

use crate::ports::{self, Port, Ports};
use crate::registers::{MachineRegister, Register};
use crate::values;

/// Something that has children.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Node {
    Registers,
    /// The equation stack.
    Stack,
    Globals,
    /// DATA_LOCAL of a file, by execution order.
    Locals(u8),
    /// Interface cells of the control that the program uses, without ports.
    Control,
    Mechanisms,
    Mechanism(u16),
    Inputs,
    Outputs,
    Port(Addr),
    /// A byte with named bits.
    Bits(Addr),
    /// An untyped area.
    Area(Addr, u32),
}

/// Where a row's value comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Shown {
    Bit {
        addr: Addr,
        bit: u8,
    },
    Cell {
        addr: Addr,
        width: Width,
    },
    Text {
        addr: Addr,
        len: u32,
    },
    Area {
        addr: Addr,
        len: u32,
    },
    Register(Register),
    /// A register of the 80386.
    Machine(MachineRegister),
    /// A value of the equation stack, 0 = top.
    Pushed(usize),
    Mechanism(u16),
    Detail(u16, Detail),
}

/// A property of a mechanism.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Detail {
    Active,
    Line,
    State,
    Condition,
    Time,
}

/// Mechanism properties in the order of display.
const DETAILS: [(&str, Detail); 5] = [
    ("active", Detail::Active),
    ("line", Detail::Line),
    ("state", Detail::State),
    ("condition", Detail::Condition),
    ("in state for", Detail::Time),
];

/// A child.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Row {
    pub(crate) name: String,
    /// An expression that evaluates to the same thing.
    pub(crate) expression: Option<String>,
    pub(crate) shown: Shown,
    pub(crate) children: Option<Node>,
}

impl Row {
    /// What the language calls its type.
    pub(crate) fn type_name(&self) -> String {
        match self.shown {
            Shown::Bit { .. } | Shown::Pushed(_) | Shown::Detail(_, Detail::Active) => "bit".into(),
            Shown::Cell { width, .. } => values::type_name(width).into(),
            Shown::Text { len, .. } => format!("STR {len}"),
            Shown::Area { len, .. } => format!("DS {len}"),
            Shown::Register(register) => register.type_name().into(),
            Shown::Machine(register) => register.type_name().into(),
            Shown::Mechanism(_) => "mechanism".into(),
            Shown::Detail(..) => "text".into(),
        }
    }

    /// Number of children that are numbered, not named.
    pub(crate) fn indexed(&self) -> Option<u32> {
        if let Some(Node::Area(_, len)) = self.children { Some(len) } else { None }
    }
}

/// The tree of one program. Handles (`variablesReference`) stay the same as long as it lives.
pub(crate) struct Tree {
    rows: HashMap<Node, Vec<Row>>,
    handles: Vec<Node>,
    numbers: HashMap<Node, i64>,
}

impl Tree {
    /// `machine`: whether the registers of the 80386 belong to it, because the program has such instructions.
    pub(crate) fn new(debug: &DebugInfo, ports: &Ports, machine: bool) -> Self {
        let mut rows = HashMap::new();
        let by_scope =
            |scope: Scope| debug.symbols.iter().filter(move |s| s.scope == scope).collect::<Vec<_>>();
        add_symbols(&mut rows, Node::Globals, &by_scope(Scope::Global));
        for order in debug.files.iter().filter_map(|f| f.order) {
            add_symbols(&mut rows, Node::Locals(order), &by_scope(Scope::File(order)));
        }
        let control: Vec<&Symbol> = by_scope(Scope::System)
            .into_iter()
            .filter(|s| !first_addr(&s.kind).is_some_and(ports::is_port))
            .collect();
        add_symbols(&mut rows, Node::Control, &control);
        add_ports(&mut rows, Node::Inputs, &ports.inputs);
        add_ports(&mut rows, Node::Outputs, &ports.outputs);
        add_mechanisms(&mut rows, debug);
        let registers = crate::registers::ALL.iter().map(|(name, register)| Row {
            name: (*name).into(),
            expression: (*register != Register::Stack).then(|| (*name).into()),
            shown: Shown::Register(*register),
            children: (*register == Register::Stack).then_some(Node::Stack),
        });
        let machine = crate::registers::MACHINE.iter().filter(|_| machine).map(|(name, register)| Row {
            name: (*name).into(),
            expression: None,
            shown: Shown::Machine(*register),
            children: None,
        });
        rows.insert(Node::Registers, registers.chain(machine).collect());
        Tree { rows, handles: Vec::new(), numbers: HashMap::new() }
    }

    /// Whether the node has anything to show.
    pub(crate) fn is_empty(&self, node: Node) -> bool {
        self.rows.get(&node).is_none_or(Vec::is_empty)
    }

    /// Number of children.
    pub(crate) fn len(&self, node: Node) -> usize {
        match node {
            Node::Area(_, len) => len as usize,
            _ => self.rows.get(&node).map_or(0, Vec::len),
        }
    }

    /// Children `from..to`, clipped to what is there.
    pub(crate) fn children(&self, node: Node, from: usize, to: usize) -> Vec<Row> {
        if let Node::Area(addr, len) = node {
            let to = to.min(len as usize);
            return (from.min(to)..to).map(|n| area_row(addr, n as u32)).collect();
        }
        let rows = self.rows.get(&node).map_or(&[][..], Vec::as_slice);
        let to = to.min(rows.len());
        rows[from.min(to)..to].to_vec()
    }

    /// The child of that name.
    pub(crate) fn child(&self, node: Node, name: &str) -> Option<Row> {
        if let Node::Area(addr, len) = node {
            let index = name.trim_start_matches('[').trim_end_matches(']').parse::<u32>().ok()?;
            return (index < len).then(|| area_row(addr, index));
        }
        self.rows.get(&node)?.iter().find(|r| r.name == name).cloned()
    }

    /// The handle of a node.
    pub(crate) fn handle(&mut self, node: Node) -> i64 {
        let handles = &mut self.handles;
        *self.numbers.entry(node).or_insert_with(|| {
            handles.push(node);
            handles.len() as i64
        })
    }

    /// The node behind a handle.
    pub(crate) fn node(&self, handle: i64) -> Option<Node> {
        let index = usize::try_from(handle).ok()?.checked_sub(1)?;
        self.handles.get(index).copied()
    }

    /// Makes the bits of a byte expandable from an expression as well; `None` when it has no named bits.
    pub(crate) fn bits_of(&self, addr: Addr) -> Option<Node> {
        [Node::Bits(addr), Node::Port(addr)].into_iter().find(|n| self.rows.contains_key(n))
    }
}

fn area_row(addr: Addr, index: u32) -> Row {
    Row {
        name: format!("[{index}]"),
        expression: None,
        shown: Shown::Cell { addr: addr.saturating_add(index), width: Width::Byte },
        children: None,
    }
}

fn first_addr(kind: &SymbolKind) -> Option<Addr> {
    match *kind {
        SymbolKind::Bit { addr, .. }
        | SymbolKind::Cell { addr, .. }
        | SymbolKind::Area { addr, .. }
        | SymbolKind::Text { addr, .. } => Some(addr),
        _ => None,
    }
}

/// Rows of one scope. Bits of a byte that has a name of its own go under that byte.
fn add_symbols(rows: &mut HashMap<Node, Vec<Row>>, scope: Node, symbols: &[&Symbol]) {
    let named_bytes: HashSet<Addr> = symbols
        .iter()
        .filter_map(|s| match s.kind {
            SymbolKind::Cell { addr, width: Width::Byte } => Some(addr),
            _ => None,
        })
        .collect();
    let mut bits: HashMap<Addr, Vec<Row>> = HashMap::new();
    let mut top = Vec::new();
    for symbol in symbols {
        let row = |shown, children| Row {
            name: symbol.name.clone(),
            expression: Some(symbol.name.clone()),
            shown,
            children,
        };
        match symbol.kind {
            SymbolKind::Bit { addr, bit } if named_bytes.contains(&addr) => {
                bits.entry(addr).or_default().push(row(Shown::Bit { addr, bit }, None));
            }
            SymbolKind::Bit { addr, bit } => top.push(row(Shown::Bit { addr, bit }, None)),
            SymbolKind::Cell { addr, width } => top.push(row(Shown::Cell { addr, width }, None)),
            SymbolKind::Area { addr, len } => {
                top.push(row(Shown::Area { addr, len }, Some(Node::Area(addr, len))));
            }
            SymbolKind::Text { addr, len } => top.push(row(Shown::Text { addr, len }, None)),
            _ => {}
        }
    }
    for row in &mut top {
        if let Shown::Cell { addr, width: Width::Byte } = row.shown
            && bits.contains_key(&addr)
        {
            row.children = Some(Node::Bits(addr));
        }
    }
    for (addr, mut children) in bits {
        children.sort_by_key(|r| if let Shown::Bit { bit, .. } = r.shown { bit } else { 8 });
        rows.insert(Node::Bits(addr), children);
    }
    rows.insert(scope, top);
}

fn add_ports(rows: &mut HashMap<Node, Vec<Row>>, scope: Node, ports: &[Port]) {
    let mut top = Vec::new();
    for port in ports {
        top.push(Row {
            name: port.name.clone(),
            expression: Some(port.name.clone()),
            shown: Shown::Cell { addr: port.addr, width: Width::Byte },
            children: Some(Node::Port(port.addr)),
        });
        let bits = port.bits.iter().zip(0_u8..).map(|(name, bit)| Row {
            name: name.as_ref().map_or_else(|| bit.to_string(), |n| format!("{bit} {n}")),
            expression: Some(format!("{}.{bit}", port.name)),
            shown: Shown::Bit { addr: port.addr, bit },
            children: None,
        });
        rows.insert(Node::Port(port.addr), bits.collect());
    }
    rows.insert(scope, top);
}

fn add_mechanisms(rows: &mut HashMap<Node, Vec<Row>>, debug: &DebugInfo) {
    let mut top = Vec::new();
    for mechanism in &debug.mechanisms {
        let node = Node::Mechanism(mechanism.sequence);
        top.push(Row {
            name: mechanism.name.clone(),
            expression: Some(mechanism.name.clone()),
            shown: Shown::Mechanism(mechanism.sequence),
            children: Some(node),
        });
        let details = DETAILS.iter().map(|(name, detail)| Row {
            name: (*name).into(),
            expression: None,
            shown: Shown::Detail(mechanism.sequence, *detail),
            children: None,
        });
        rows.insert(node, details.collect());
    }
    rows.insert(Node::Mechanisms, top);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    fn tree() -> Tree {
        let image = sample::image();
        let debug = image.debug.as_ref().unwrap();
        Tree::new(debug, &ports::used(&image.program, debug), false)
    }

    fn names(tree: &Tree, node: Node) -> Vec<String> {
        tree.children(node, 0, usize::MAX)
            .into_iter()
            .map(|r| format!("{}: {}", r.name, r.type_name()))
            .collect()
    }

    #[test]
    fn scopes_hold_what_was_declared_in_them() {
        let tree = tree();
        assert_eq!(
            names(&tree, Node::Globals),
            [
                "INPUTS: BYTE",
                "OUTPUTS: BYTE",
                "COUNT: WORD",
                "SPEED: DWRD",
                "TITLE: STR 8",
                "TABLE: DS 20",
                "RATIO: REAL",
                "LONELY: bit"
            ]
        );
        assert_eq!(names(&tree, Node::Bits(sample::INPUTS)), ["KSMP: bit", "KSMM: bit"]);
        assert_eq!(names(&tree, Node::Locals(1)), ["STEP_NO: BYTE"]);
        assert!(tree.is_empty(Node::Locals(0)));
        assert_eq!(names(&tree, Node::Mechanisms), ["SPINDLE: mechanism", "TURRET: mechanism"]);
        assert_eq!(names(&tree, Node::Inputs), ["P1IN: BYTE"]);
        assert_eq!(names(&tree, Node::Port(0))[..3], ["0 KSMP: bit", "1 KSMM: bit", "2: bit"]);
        assert_eq!(names(&tree, Node::Control), ["PB07: BYTE"]);
    }

    #[test]
    fn areas_are_paged() {
        let tree = tree();
        let area = Node::Area(sample::TABLE, 20);
        assert_eq!(tree.len(area), 20);
        let names: Vec<String> = tree.children(area, 18, 30).into_iter().map(|r| r.name).collect();
        assert_eq!(names, ["[18]", "[19]"]);
        assert_eq!(
            tree.child(area, "[19]").map(|r| r.shown),
            Some(Shown::Cell { addr: sample::TABLE + 19, width: Width::Byte })
        );
        assert_eq!(tree.child(area, "[20]"), None);
        assert!(tree.children(area, 40, 20).is_empty());
    }

    #[test]
    fn handles_are_stable_and_wild_ones_are_refused() {
        let mut tree = tree();
        let one = tree.handle(Node::Globals);
        let two = tree.handle(Node::Mechanism(0));
        assert_eq!((tree.handle(Node::Globals), tree.handle(Node::Mechanism(0))), (one, two));
        assert_eq!(tree.node(two), Some(Node::Mechanism(0)));
        for wild in [0, -1, 3, i64::MAX, i64::MIN] {
            assert_eq!(tree.node(wild), None);
        }
    }
}
