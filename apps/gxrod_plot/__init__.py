"""Pictures of gxrod's results: shapes, histories, the energy ledger, the figures of rubin2007."""
