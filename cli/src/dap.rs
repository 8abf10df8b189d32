//! `technol dap` and `technol lsp`: the two servers.

use std::net::TcpListener;
use std::path::Path;
use std::sync::Arc;

use technol_dap::{FileBuilder, Surroundings};
use technol_target::Address;

use crate::arguments::DapArguments;
use crate::connector::Targets;
use crate::exit::{self, Failure, Outcome};
use crate::out::say;

/// What every session of the adapter works with.
pub(crate) fn surroundings() -> Surroundings {
    surroundings_with(None)
}

/// The same with a file in which embedded targets keep PLC_MEM_BACKUP.
pub(crate) fn surroundings_with(backup: Option<&Path>) -> Surroundings {
    let connector = Targets { backup: backup.map(Path::to_owned) };
    Surroundings { connector: Arc::new(connector), builder: Arc::new(FileBuilder) }
}

/// Serves one editor on stdio, or one after another on TCP.
pub(crate) fn dap(arguments: &DapArguments) -> Outcome {
    let surroundings = surroundings();
    let Some(listen) = &arguments.listen else {
        technol_dap::serve_stdio(&surroundings)
            .map_err(|e| Failure::usage(format!("the editor is gone: {e}")))?;
        return Ok(exit::OK);
    };
    let (host, port) = tcp_address(listen)?;
    let listener = TcpListener::bind((host.as_str(), port)).map_err(|e| {
        Failure::usage(format!(
            "cannot listen at tcp:{host}:{port}: {e}; choose another port, or 0 for any free one"
        ))
    })?;
    if let Ok(address) = listener.local_addr() {
        say!("listening at tcp:{}:{}", address.ip(), address.port());
    }
    technol_dap::serve_tcp(&listener, &surroundings)
        .map_err(|e| Failure::usage(format!("tcp:{host}:{port} failed: {e}")))?;
    Ok(exit::OK)
}

/// Host and port of `tcp:HOST:PORT`.
pub(crate) fn tcp_address(text: &str) -> Result<(String, u16), Failure> {
    match text.parse::<Address>() {
        Ok(Address::Tcp { host, port }) => Ok((host, port)),
        Ok(_) => Err(Failure::usage(format!("`{text}` cannot be listened at; write tcp:HOST:PORT"))),
        Err(error) => Err(Failure::usage(error.to_string())),
    }
}

/// Serves one editor on stdio.
pub(crate) fn lsp() -> u8 {
    technol_lsp::run_stdio()
}
