"""Pictures of gxrod's results: deflected shapes, histories, the energy ledger, and the figures of rubin2007."""
