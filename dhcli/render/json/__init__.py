"""Results as JSON: one envelope, and what stands under its data. The keys are a contract."""
