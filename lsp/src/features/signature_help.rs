//! The operands of the instruction being written.

use technol_analysis::{Cancellable, Parameter};
use tower_lsp::ls_types::request::SignatureHelpRequest;
use tower_lsp::ls_types::{
    Documentation, MarkupContent, MarkupKind, ParameterInformation, ParameterLabel, SignatureHelp,
    SignatureHelpParams, SignatureInformation,
};

use super::{Feature, Views, of_document};
use crate::view::View;

pub(super) struct Signatures;

impl Feature for Signatures {
    type Request = SignatureHelpRequest;

    fn views(params: &SignatureHelpParams, views: &dyn Views) -> Vec<View> {
        of_document(&params.text_document_position_params.text_document.uri, views)
    }

    fn answer(views: &[View], params: &SignatureHelpParams) -> Cancellable<Option<SignatureHelp>> {
        let [view] = views else { return Ok(None) };
        let position = view.position(params.text_document_position_params.position);
        let Some(help) = view.analysis.signature_help(&view.file, position, view.language)? else {
            return Ok(None);
        };
        // Behind the last operand none is marked: an index past the end says so to clients that know no null.
        let active = help.active.unwrap_or(help.parameters.len() as u32);
        let parameters = help.parameters.iter().map(|it| parameter(&help.label, it)).collect();
        let signature = SignatureInformation {
            documentation: (!help.documentation.is_empty()).then(|| markdown(help.documentation)),
            parameters: Some(parameters),
            active_parameter: Some(active),
            label: help.label,
        };
        Ok(Some(SignatureHelp {
            signatures: vec![signature],
            active_signature: Some(0),
            active_parameter: Some(active),
        }))
    }
}

/// Offsets in a label count UTF-16 units, whatever encoding positions have.
fn parameter(label: &str, parameter: &Parameter) -> ParameterInformation {
    let units = |byte: u32| label.get(..byte as usize).map_or(0, |head| head.encode_utf16().count() as u32);
    ParameterInformation {
        label: ParameterLabel::LabelOffsets([units(parameter.label.0), units(parameter.label.1)]),
        documentation: (!parameter.documentation.is_empty())
            .then(|| markdown(parameter.documentation.clone())),
    }
}

fn markdown(value: String) -> Documentation {
    Documentation::MarkupContent(MarkupContent { kind: MarkupKind::Markdown, value })
}
