//! What the instructions share that take several cycles and tell their end in RLO and DR (PLCT_, ECAT_).

use super::entry::{Effect, Entry};
use super::pattern::MULTI_CYCLE;

/// Such an instruction.
pub(super) const TRANSFER: Entry =
    Entry { reads: &[Effect::Memory], writes: &[Effect::Rlo, Effect::Dr, Effect::Memory], ..MULTI_CYCLE };

/// How such an instruction tells its result.
macro_rules! en_result {
    () => {
        "\n\nThe transfer takes several cycles. Meanwhile the instruction gives RLO 0 and DR 0, at the end \
         RLO 1 and in DR 0 or the number of an error. An EX0 behind it therefore waits for the end; it leaves \
         DR as it is. The instruction acts as if BEX stood before it: while EX0 waits, only the two are \
         repeated and the transfer is started once. Besides mechanisms it may stand in MODULE_BLOCK_INIT and \
         MODULE_BLOCK_DONE (this implementation)."
    };
}
/// The same in Czech.
macro_rules! cs_result {
    () => {
        "\n\nPřenos trvá několik cyklů. Instrukce zatím vrací RLO 0 a DR 0, na konci RLO 1 a v DR 0 nebo \
         číslo chyby. EX0 za ní proto čeká na konec; DR přitom nemění. Instrukce se chová, jako by před ní \
         stálo BEX: dokud EX0 čeká, opakují se jen tyto dvě a přenos se spustí jednou. Kromě mechanismů smí \
         stát i v MODULE_BLOCK_INIT a MODULE_BLOCK_DONE (tato implementace)."
    };
}

pub(super) use {cs_result, en_result};
