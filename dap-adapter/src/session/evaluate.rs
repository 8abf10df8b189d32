//! Expressions: hovers, watches, the debug console, setting what an expression names, completion.

use dap::requests::{CompletionsArguments, EvaluateArguments, SetExpressionArguments};
use dap::responses::{CompletionsResponse, EvaluateResponse, SetExpressionResponse};
use dap::types::{CompletionItem, CompletionItemType, EvaluateArgumentsContext};

use technol_image::debug_info::{Scope, SymbolKind};
use technol_image::op::Width;

use crate::errors::RequestError;
use crate::expression::{self, Named};
use crate::request::Request;
use crate::tree::{Node, Row, Shown};
use crate::values;

use super::inspect::wants_hex;
use super::{Answer, Session, body, repl};

/// Completions offered at once.
const OFFERED: usize = 100;

impl Session {
    pub(super) fn evaluate(&mut self, request: &Request) -> Answer {
        let arguments: EvaluateArguments = request.parse()?;
        let order = self.order_of_frame(request, arguments.frame_id)?;
        if matches!(arguments.context, Some(EvaluateArgumentsContext::Repl))
            && let Some(said) = self.command(&arguments.expression, order)?
        {
            return body(&EvaluateResponse { result: said, ..EvaluateResponse::default() });
        }
        let hex = wants_hex(arguments.format.as_ref());
        let named = self.named(order, &arguments.expression)?;
        let Named::Thing(shown) = named else {
            let Named::Constant(value) = named else { return body(&EvaluateResponse::default()) };
            return body(&EvaluateResponse {
                result: values::register(value as u64, width_of(value), hex),
                type_field: Some("constant".into()),
                ..EvaluateResponse::default()
            });
        };
        let row = self.row(&arguments.expression, shown)?;
        let result = self.show(std::slice::from_ref(&row), hex)?.pop().unwrap_or_default();
        let (_, debuggee) = self.parts()?;
        body(&EvaluateResponse {
            result,
            type_field: Some(row.type_name()),
            variables_reference: row.children.map_or(0, |node| debuggee.tree.handle(node)),
            indexed_variables: row.indexed().map(i64::from),
            ..EvaluateResponse::default()
        })
    }

    pub(super) fn set_expression(&mut self, request: &Request) -> Answer {
        let arguments: SetExpressionArguments = request.parse()?;
        let order = self.order_of_frame(request, arguments.frame_id)?;
        let hex = wants_hex(arguments.format.as_ref());
        let (value, type_name) = self.assign(order, &arguments.expression, &arguments.value, hex)?;
        body(&SetExpressionResponse {
            value,
            type_field: Some(type_name),
            presentation_hint: None,
            variables_reference: None,
            named_variables: None,
            indexed_variables: None,
        })
    }

    /// Sets what an expression names; answers the new value and its type.
    pub(super) fn assign(
        &mut self,
        order: Option<u8>,
        expression: &str,
        value: &str,
        hex: bool,
    ) -> Result<(String, String), RequestError> {
        let Named::Thing(shown) = self.named(order, expression)? else {
            let name = expression.trim().to_owned();
            return Err(RequestError::ReadOnly { name, reason: "it is a constant" });
        };
        let row = self.row(expression, shown)?;
        let value = self.set(&shown, expression.trim(), value, hex)?;
        self.values_changed();
        Ok((value, row.type_name()))
    }

    pub(super) fn named(&self, order: Option<u8>, expression: &str) -> Result<Named, RequestError> {
        let debuggee = self.debuggee()?;
        expression::resolve(&debuggee.debug, order, expression).map_err(RequestError::Expression)
    }

    /// The row that an expression stands for, with what it expands into.
    fn row(&self, expression: &str, shown: Shown) -> Result<Row, RequestError> {
        let tree = &self.debuggee()?.tree;
        let children = match shown {
            Shown::Cell { addr, width: Width::Byte } => tree.bits_of(addr),
            Shown::Area { addr, len } => Some(Node::Area(addr, len)),
            Shown::Mechanism(n) => Some(Node::Mechanism(n)),
            _ => None,
        };
        Ok(Row { name: expression.trim().to_owned(), expression: None, shown, children })
    }

    /// The file whose local data an expression sees: that of the frame, or of the stop.
    pub(super) fn order_of_frame(
        &mut self,
        request: &Request,
        frame: Option<i64>,
    ) -> Result<Option<u8>, RequestError> {
        match frame {
            // Clients keep asking about the frame they had for a moment after the program went on.
            Some(id) if self.debuggee()?.stop.is_some() => Ok(self.frame(request, id)?.order),
            _ => Ok(None),
        }
    }

    pub(super) fn completions(&mut self, request: &Request) -> Answer {
        let arguments: CompletionsArguments = request.parse()?;
        let order = self.order_of_frame(request, arguments.frame_id)?;
        let cursor = usize::try_from(arguments.column - self.client.first_column).unwrap_or(0);
        let before: String = arguments.text.chars().take(cursor).collect();
        let is_part = |c: char| c.is_alphanumeric() || matches!(c, '_' | '?' | '@');
        let word: String =
            before.chars().rev().take_while(|c| is_part(*c)).collect::<Vec<_>>().into_iter().rev().collect();
        let matches = |name: &str| name.to_lowercase().starts_with(&word.to_lowercase());
        let mut targets = Vec::new();
        if before.trim_start() == word {
            let commands = repl::COMMANDS.iter().filter(|(usage, _)| matches(usage));
            targets.extend(commands.map(|(usage, help)| {
                let name = usage.split(' ').next().unwrap_or(usage);
                item(name, CompletionItemType::Function, help)
            }));
        }
        let debuggee = self.debuggee()?;
        for symbol in debuggee.debug.symbols.iter().filter(|s| matches(&s.name)) {
            if matches!(symbol.scope, Scope::File(n) if order.is_some_and(|o| o != n)) {
                continue;
            }
            let (kind, detail) = match symbol.kind {
                SymbolKind::Procedure { .. } | SymbolKind::Label { .. } => continue,
                SymbolKind::Constant { .. } => (CompletionItemType::Value, "constant"),
                SymbolKind::Mechanism { .. } => (CompletionItemType::Module, "mechanism"),
                SymbolKind::Bit { .. } => (CompletionItemType::Variable, "bit"),
                SymbolKind::Cell { width, .. } => (CompletionItemType::Variable, values::type_name(width)),
                SymbolKind::Area { .. } => (CompletionItemType::Variable, "area"),
                SymbolKind::Text { .. } => (CompletionItemType::Variable, "text"),
            };
            targets.push(item(&symbol.name, kind, detail));
        }
        targets.truncate(OFFERED);
        body(&CompletionsResponse { targets })
    }
}

fn item(label: &str, kind: CompletionItemType, detail: &str) -> CompletionItem {
    CompletionItem {
        label: label.to_owned(),
        type_field: Some(kind),
        detail: Some(detail.to_owned()),
        ..CompletionItem::default()
    }
}

/// The smallest width that holds a constant.
fn width_of(value: i64) -> Width {
    let fits = |width: Width| (-(1_i64 << (width.bits() - 1))..1_i64 << width.bits()).contains(&value);
    [Width::Byte, Width::Word, Width::DWord].into_iter().find(|w| fits(*w)).unwrap_or(Width::QWord)
}
